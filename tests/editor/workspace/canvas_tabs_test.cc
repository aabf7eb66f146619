#include "editor/workspace/canvas_tabs.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class CanvasTabsTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(driver_.editor.Open(file_.path()));
    driver_.Frames();
  }
  std::string Shown() { return driver_.editor.state().workspace.ShownTreeId(); }
  std::size_t Count() { return driver_.editor.state().canvas.tabs.size(); }
  void Run(const char* command) {
    driver_.editor.state().commands.Run(command);
    driver_.Frames(20);
  }

  const TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(CanvasTabsTest, ASubTreeThatIsClickedTwiceOpensInATabOfItsOwn) {
  EXPECT_FALSE(driver_.Has("canvasbar/tab/MainTree")) << "one tree needs no tab";
  const Box box = driver_.BoxOf("canvas/MainTree/1.2");
  driver_.ClickAt({box.min.x + 30, box.min.y + 8});
  driver_.ClickAt({box.min.x + 30, box.min.y + 8});
  driver_.Frames();
  EXPECT_EQ(Shown(), "Walk");
  EXPECT_EQ(Count(), 2U);
  EXPECT_TRUE(driver_.Click("canvasbar/tab/MainTree"));
  EXPECT_EQ(Shown(), "MainTree");
}

TEST_F(CanvasTabsTest, KeysWalkThroughTabsAndCloseThem) {
  driver_.editor.state().workspace.ShowFileTree(0, 1, driver_.editor.now());
  driver_.Frames();
  ASSERT_EQ(Count(), 2U);
  Run("tab.next");
  EXPECT_EQ(Shown(), "MainTree");
  Run("tab.previous");
  EXPECT_EQ(Shown(), "Walk");
  Run("tab.close");
  EXPECT_EQ(Shown(), "MainTree");
  Run("tab.close");
  EXPECT_EQ(Count(), 1U) << "the last tab stays";
}

TEST_F(CanvasTabsTest, ATreeThatIsGoneLosesItsTab) {
  ShowTab(driver_.editor.state(), 7, 0);  // there is none
  driver_.editor.state().canvas.tabs.push_back({file_.path(), "Gone"});
  driver_.Frames();
  EXPECT_EQ(Count(), 1U);
}

TEST_F(CanvasTabsTest, StepsOnTheWayToANodeCanBeClicked) {
  driver_.Click("canvas/MainTree/1.2.1.1");
  ASSERT_EQ(driver_.Selected(), "1.2.1.1");
  EXPECT_TRUE(driver_.Click("canvasbar/crumb/2"));
  EXPECT_EQ(driver_.Selected(), "1.2") << "the SubTree that it lies in";
}

TEST_F(CanvasTabsTest, CompactPutsDecoratorsOnTheirChildren) {
  const auto gap = [&] {
    return driver_.BoxOf("canvas/MainTree/1.1.1.1").min.y -
           driver_.BoxOf("canvas/MainTree/1.1.1").max.y;
  };
  EXPECT_GT(gap(), 10);
  EXPECT_TRUE(driver_.Click("canvasbar/compact"));
  driver_.Frames(20);
  EXPECT_LT(gap(), 4);
}

}  // namespace
}  // namespace coppice::editor
