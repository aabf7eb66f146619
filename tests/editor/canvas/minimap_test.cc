#include <gtest/gtest.h>

#include "editor/canvas/canvas.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Minimap, MovesTheCameraToWhereItIsClicked) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  driver.view().ZoomAt({0, 0}, 2);
  driver.Frames();
  const Box map = driver.BoxOf("canvas/minimap");
  ASSERT_GT(map.width(), 50);
  driver.ClickAt({map.min.x + 12, map.center().y});
  const float left = driver.view().camera.offset.x;
  driver.ClickAt({map.max.x - 12, map.center().y});
  EXPECT_LT(driver.view().camera.offset.x, left - 50);
}

constexpr char kMany[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Many"><Sequence>)";

// Three levels of many leaves.
std::string DenseFile() {
  std::string text = kMany;
  for (int i = 0; i < 12; ++i) {
    text += "<Sequence>";
    for (int k = 0; k < 6; ++k) text += "<AlwaysSuccess/><AlwaysFailure/>";
    text += "</Sequence>";
  }
  return text + "</Sequence></BehaviorTree></root>";
}

class MinimapOfADenseTree : public testing::Test {
 protected:
  MinimapOfADenseTree() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }

  // Looks at that point of the tree, the mouse elsewhere.
  void LookAt(Point world, float zoom) {
    driver_.MoveTo({5, 5});
    driver_.view().camera.zoom = zoom;
    driver_.view().camera.offset = driver_.editor.state().screen.canvas_size * 0.5F - world * zoom;
    driver_.Frames(3);
  }

  int NodesUnder(const Box& box) {
    int count = 0;
    for (const auto& [path, node] : driver_.editor.items().all()) {
      count += path.rfind("canvas/Many/", 0) == 0 && node.Overlaps(box);
    }
    return count;
  }

  TemporaryFile file_{"dense.xml", DenseFile()};
  Driver driver_;
};

TEST_F(MinimapOfADenseTree, IsAlwaysThereAndCoversNodesOnlyWhereNoCornerIsFree) {
  const Box all = driver_.view().bounds();
  int covers = 0;
  for (int i = 0; i <= 10; ++i) {
    for (int k = 0; k <= 10; ++k) {
      const auto part = [](int n) { return static_cast<float>(n) / 10; };
      LookAt(all.min + Point{part(i) * all.width(), part(k) * all.height()}, 0.8F);
      ASSERT_TRUE(driver_.Has("canvas/minimap")) << i << " " << k;
      covers += driver_.view().minimap.covers;
      if (driver_.view().minimap.covers) continue;
      EXPECT_EQ(NodesUnder(driver_.BoxOf("canvas/minimap")), 0) << i << " " << k;
    }
  }
  EXPECT_LT(covers, 100) << "there is often room";
  EXPECT_GT(covers, 0) << "and sometimes none";
}

TEST_F(MinimapOfADenseTree, NodesAreSeenThroughItUntilTheMouseIsOnIt) {
  const Box all = driver_.view().bounds();
  driver_.view().minimap.covers = false;
  for (int i = 0; i <= 40 && !driver_.view().minimap.covers; ++i) {
    const float down = all.height() * static_cast<float>(i) / 40;
    LookAt({all.center().x, all.min.y + down}, 0.8F);
  }
  ASSERT_TRUE(driver_.view().minimap.covers);
  const Color panel = GetPalette(PaletteName::kDark).panel;
  const Box map = driver_.BoxOf("canvas/minimap");
  const int through = driver_.CountColor(map, panel, 2);
  driver_.MoveTo(map.center());
  driver_.Frames();
  EXPECT_GT(driver_.CountColor(map, panel, 2), through + 500);
}

TEST_F(MinimapOfADenseTree, StaysWhereItIsWhileItIsDragged) {
  LookAt(driver_.view().bounds().min, 0.8F);
  ASSERT_TRUE(driver_.Has("canvas/minimap"));
  const Box map = driver_.BoxOf("canvas/minimap");
  driver_.MoveTo(map.center());
  driver_.Frames();
  driver_.Carry(map.center(), map.min + Point{20, 20});
  for (int i = 0; i < 8; ++i) {
    driver_.MoveTo(map.min + Point{20 + static_cast<float>(i) * 16, 40});
    driver_.Frames(1);
    EXPECT_EQ(driver_.BoxOf("canvas/minimap"), map);
  }
}

TEST(Minimap, CanBeHidden) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  driver.view().ZoomAt({0, 0}, 3);
  driver.Frames();
  EXPECT_TRUE(driver.Has("canvas/minimap"));
  driver.Press(kKeyF1 + 10);
  EXPECT_FALSE(driver.Has("canvas/minimap"));
}

TEST(Minimap, IsNotThereWhenTheWholeTreeIsInSight) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  driver.Press(kKeyHome);
  driver.Frames(12);
  EXPECT_FALSE(driver.Has("canvas/minimap"));
  driver.view().ZoomAt({0, 0}, 3);
  driver.Frames();
  EXPECT_TRUE(driver.Has("canvas/minimap"));
}

}  // namespace
}  // namespace coppice::editor
