#include "editor/core/canvas_drops.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

constexpr char kFile[] = R"(<root BTCPP_format="4"><BehaviorTree ID="T"><Sequence>
  <AlwaysSuccess name="a"/>
  <AlwaysFailure name="b"/>
  <Fallback name="inner"><AlwaysSuccess name="c"/></Fallback>
</Sequence></BehaviorTree></root>
)";

class CanvasDropsTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(driver_.editor.Open(file_.path()));
    driver_.Frames();
  }

  // Names in preorder.
  std::string Names() {
    std::string names;
    for (const SceneNode& node : driver_.view().scene()->nodes) {
      names += (names.empty() ? "" : " ") + node.path + ":" + std::string(node.name);
    }
    return names;
  }
  DropRequest Request(DropPlace place, const std::string& path, std::uint32_t index = 0) {
    DropRequest request;
    request.target = {place, driver_.view().scene()->FindPath(path), index, {}};
    return request;
  }
  void Select(const std::string& path) {
    driver_.view().Select(driver_.view().scene()->FindPath(path));
  }
  std::string WhyNot(const DropRequest& request) {
    return WhyNoDrop(driver_.editor.state(), driver_.editor.now(), request);
  }

  const TemporaryFile file_{"t.xml", kFile};
  Driver driver_;
};

TEST_F(CanvasDropsTest, TheMouseCarriesANodeIntoAnother) {
  driver_.Drag(driver_.BoxOf("canvas/T/1.1").center(), driver_.BoxOf("canvas/T/1.3").center());
  driver_.Frames(20);
  EXPECT_EQ(Names(), "1:Sequence 1.1:b 1.2:inner 1.2.1:c 1.2.2:a");
  EXPECT_EQ(driver_.Selected(), "1.2.2");
  driver_.editor.state().commands.Run("edit.undo");
  driver_.Frames(20);
  EXPECT_EQ(Names(), "1:Sequence 1.1:a 1.2:b 1.3:inner 1.3.1:c");
}

TEST_F(CanvasDropsTest, TheMouseCarriesANodeBetweenOthers) {
  const Box b = driver_.BoxOf("canvas/T/1.2");
  driver_.Drag(driver_.BoxOf("canvas/T/1.3.1").center(), {b.min.x + 3, b.center().y});
  driver_.Frames(20);
  EXPECT_EQ(Names(), "1:Sequence 1.1:a 1.2:c 1.3:b 1.4:inner");
}

TEST_F(CanvasDropsTest, ALeafIsNoPlaceForANode) {
  Select("1.1");
  EXPECT_EQ(WhyNot(Request(DropPlace::kNode, "1.2")), "b takes no children");
  driver_.Drag(driver_.BoxOf("canvas/T/1.1").center(), driver_.BoxOf("canvas/T/1.2").center());
  driver_.Frames(20);
  EXPECT_EQ(Names(), "1:Sequence 1.1:a 1.2:b 1.3:inner 1.3.1:c");
}

TEST_F(CanvasDropsTest, TheAnswerIsThatForWhatIsSelectedNow) {
  Select("1.3");
  EXPECT_NE(WhyNot(Request(DropPlace::kNode, "1.3")), "");
  Select("1.1");
  EXPECT_EQ(WhyNot(Request(DropPlace::kNode, "1.3")), "");
}

TEST_F(CanvasDropsTest, ShiftCopiesAndAltReplaces) {
  Select("1.1");
  DropRequest copy = Request(DropPlace::kGap, "1.3", 0);
  copy.copy = true;
  EXPECT_EQ(WhyNot(copy), "");
  Drop(driver_.editor.state(), driver_.editor.now(), copy);
  EXPECT_EQ(Names(), "1:Sequence 1.1:a 1.2:b 1.3:inner 1.3.1:a 1.3.2:c");
  Select("1.2");
  DropRequest replace = Request(DropPlace::kNode, "1.3.2");
  replace.replace = true;
  Drop(driver_.editor.state(), driver_.editor.now(), replace);
  EXPECT_EQ(Names(), "1:Sequence 1.1:a 1.2:inner 1.2.1:a 1.2.2:b");
}

TEST_F(CanvasDropsTest, ALineMeansAroundTheNodeBelowIt) {
  Select("1.3");
  Drop(driver_.editor.state(), driver_.editor.now(), Request(DropPlace::kEdge, "1.1"));
  EXPECT_EQ(Names(), "1:Sequence 1.1:inner 1.1.1:c 1.1.2:a 1.2:b");
  DropRequest copy = Request(DropPlace::kEdge, "1.2");
  copy.copy = true;
  EXPECT_NE(WhyNot(copy), "");
}

}  // namespace
}  // namespace coppice::editor
