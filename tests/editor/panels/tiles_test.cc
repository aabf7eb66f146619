#include "editor/panels/tiles.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Tiles, CoverTheWindowWithoutOverlap) {
  Driver driver;
  driver.Frames();
  std::vector<Box> boxes;
  for (const char* path :
       {"project", "outline", "types", "inspector", "blackboard", "xml", "problems"}) {
    boxes.push_back(driver.BoxOf(path));
  }
  float area = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    area += boxes[i].width() * boxes[i].height();
    for (std::size_t j = i + 1; j < boxes.size(); ++j) EXPECT_FALSE(boxes[i].Overlaps(boxes[j]));
  }
  const Point canvas = driver.editor.state().screen.canvas_size;
  EXPECT_GT(area + canvas.x * canvas.y, 0.88F * 1280 * 800);
}

TEST(Tiles, AreResizedByTheirSplitters) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.OpenRow();
  driver.AddRobot("robot:1", kLiveTree);
  driver.Frames();
  const float left = driver.BoxOf("project").width();
  const float bottom = driver.BoxOf("xml").height();
  const float inspector = driver.BoxOf("inspector").height();
  const auto drag = [&](const char* path, Point by) {
    const Point from = driver.BoxOf(path).center();
    driver.Drag(from, from + by);
  };
  drag("split/left", {50, 0});
  drag("split/bottom", {0, -40});
  drag("split/right_part", {0, -30});
  EXPECT_NEAR(driver.BoxOf("project").width(), left + 50, 2);
  EXPECT_NEAR(driver.BoxOf("xml").height(), bottom + 40, 2);
  EXPECT_NEAR(driver.BoxOf("inspector").height(), inspector - 30, 2);
}

TEST(Tiles, KeepATreeFittedThatTheUserHasNotMoved) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames(12);
  const auto is_fitted = [&] {
    TreeView fitted = driver.view();
    fitted.FitAll(driver.editor.state().screen.canvas_size);
    return fitted.camera == driver.view().camera;
  };
  ASSERT_TRUE(is_fitted());
  driver.input.width = 1000;
  driver.input.height = 640;
  driver.Frames();
  EXPECT_TRUE(is_fitted()) << "the window is smaller";
  const Point bar = driver.BoxOf("split/left").center();
  driver.Drag(bar, bar + Point{80, 0});
  driver.Press(kKeyF1 + 6);
  driver.Press(kKeyF1 + 7);
  EXPECT_TRUE(is_fitted()) << "other tiles";
  driver.view().ZoomAt({100, 100}, 1.3F);
  driver.input.width = 1200;
  driver.Frames();
  EXPECT_FALSE(is_fitted()) << "the user has his own view";
}

TEST(Tiles, WithNothingToShowGiveTheirRoomToTheirNeighbours) {
  Driver driver;
  driver.Frames();
  const float no_file = driver.BoxOf("project").height();
  EXPECT_LT(no_file, 100) << "it only says how to open one";
  EXPECT_LT(driver.BoxOf("blackboard").height(), 110);
  const Point bar = driver.BoxOf("split/left_part").center();
  driver.Drag(bar, bar + Point{0, 40});
  EXPECT_NEAR(driver.BoxOf("project").height(), no_file + 40, 2) << "unless the user wants it";
  const TemporaryFile file("small.xml", kSmallFile);
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  EXPECT_GT(driver.BoxOf("project").height(), no_file + 20);
  driver.AddRobot("robot:1", kLiveTree);
  driver.Frames();
  EXPECT_GT(driver.BoxOf("blackboard").height(), 200);
}

TEST(Tiles, TheRowBelowTheCanvasIsOpenedByAClickAndFoldedByItsSplitter) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  EXPECT_FALSE(driver.Has("xml/1"));
  EXPECT_LT(driver.BoxOf("xml").height(), 30) << "its title alone";
  ASSERT_TRUE(driver.Click("fold/bottom"));
  EXPECT_TRUE(driver.Has("xml/1"));
  const Point splitter = driver.BoxOf("split/bottom").center();
  driver.Drag(splitter, splitter + Point{0, 160});
  driver.Frames();
  EXPECT_LT(driver.BoxOf("xml").height(), 30);
}

TEST(Tiles, TheCanvasOwnsTheWindow) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.input.width = 1600;
  driver.input.height = 1000;
  driver.editor.Open(file.path());
  driver.Frames();
  const auto part = [&driver] {
    const Point canvas = driver.editor.state().screen.canvas_size;
    return canvas.x * canvas.y / (1600 * 1000);
  };
  EXPECT_GE(part(), 0.6F) << "where trees are edited";
  driver.AddRobot("robot:1", kLiveTree);
  driver.Frames();
  EXPECT_GE(part(), 0.45F) << "where a robot is watched";
  driver.Press(kKeyF1 + 10, kCtrl);
  driver.Frames();
  EXPECT_GE(part(), 0.9F) << "where a key has sent all else away";
}

TEST(Tiles, GiveTheRoomOfHiddenOnesToTheCanvas) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.OpenRow();
  const Point before = driver.editor.state().screen.canvas_size;
  driver.Press(kKeyF1 + 1, kShift);
  driver.Press(kKeyF1 + 2, kCtrl | kShift);
  driver.Press(kKeyF1 + 2, kCtrl);
  for (const int key : {4, 6, 7, 8}) driver.Press(kKeyF1 + key - 1);
  const Point after = driver.editor.state().screen.canvas_size;
  EXPECT_GT(after.x, before.x + 400);
  EXPECT_GT(after.y, before.y + 100);
}

TEST(Tiles, GiveTheRoomOfTheNodesToTheOutlineWhileARunIsShown) {
  Driver driver;
  driver.Frames();
  const float before = driver.BoxOf("outline").height();
  ASSERT_TRUE(driver.Has("types"));
  driver.AddRobot("robot:1", kLiveTree);
  driver.Frames();
  EXPECT_FALSE(driver.Has("types"));
  EXPECT_GT(driver.BoxOf("outline").height(), before + 100);
  driver.Press(kKeyF1 + 1, kShift);
  driver.Press(kKeyF1 + 2, kCtrl);
  EXPECT_TRUE(driver.Has("types")) << "it says why it is empty if it stands alone";
}

TEST(Tiles, AreLargerOnALargeScreen) {
  Driver small;
  small.AddRobot("robot:1", kLiveTree);
  small.Frames();
  Driver large;
  large.input.width = 2560;
  large.input.height = 1440;
  large.AddRobot("robot:1", kLiveTree);
  large.Frames();
  for (const char* path : {"timeline", "run"}) {
    EXPECT_GT(large.BoxOf(path).height(), 1.3F * small.BoxOf(path).height()) << path;
  }
  EXPECT_GT(large.BoxOf("inspector").width(), 1.3F * small.BoxOf("inspector").width());
  const float before = large.BoxOf("project").width();
  const Point from = large.BoxOf("split/left").center();
  large.Drag(from, from + Point{50, 0});
  EXPECT_NEAR(large.BoxOf("project").width(), before + 50, 2) << "the splitter stays at the mouse";
}

}  // namespace
}  // namespace coppice::editor
