// From difference to difference, by keys and by the mouse.
#include <gtest/gtest.h>

#include "tests/editor/driver.h"
#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

constexpr char kBefore[] =
    R"(<root BTCPP_format="4"><BehaviorTree ID="Patrol"><Sequence name="round">
  <Go name="there" speed="1"/><Look name="look"/><Go name="back"/></Sequence>
  </BehaviorTree></root>)";
constexpr char kAfter[] =
    R"(<root BTCPP_format="4"><BehaviorTree ID="Patrol"><Sequence name="round">
  <Go name="there" speed="2"/><Go name="back"/><Dock name="dock"/></Sequence>
  </BehaviorTree></root>)";

class VersionsStory : public testing::Test {
 protected:
  VersionsStory() {
    driver_.editor.Open(after_.path());
    driver_.Frames();
    driver_.Press('D', kAlt);
    driver_.Frames();
    driver_.Type(before_.path());
    driver_.Press(kKeyEnter);
    driver_.Frames(6);
  }
  Comparison& shown() { return *driver_.editor.state().canvas.comparison; }
  std::string SelectedName() {
    const TreeView& view = shown().view();
    return std::string(view.scene()->nodes[view.selected()].name);
  }

  const TemporaryFile before_{"before.xml", kBefore};
  const TemporaryFile after_{"after.xml", kAfter};
  Driver driver_;
};

TEST_F(VersionsStory, KeysGoThroughAllDifferencesAndAround) {
  ASSERT_EQ(shown().differences().size(), 3U);
  driver_.Press('N', kAlt);
  EXPECT_EQ(SelectedName(), "there");
  driver_.Press('N', kAlt | kShift);
  EXPECT_EQ(SelectedName(), "dock");
  driver_.Press('N', kAlt | kShift);
  driver_.Frames();
  EXPECT_EQ(shown().selected(), 1U);
  driver_.Picture("differences");
}

TEST_F(VersionsStory, ButtonsDoTheSame) {
  ASSERT_TRUE(driver_.Click("comparison/previous"));
  driver_.Frames();
  EXPECT_EQ(SelectedName(), "dock");
  ASSERT_TRUE(driver_.Click("comparison/next"));
  driver_.Frames();
  EXPECT_EQ(SelectedName(), "there");
}

TEST_F(VersionsStory, AClickOnASentenceGoesToItsNode) {
  ASSERT_TRUE(driver_.Click("comparison/difference/2"));
  driver_.Frames();
  EXPECT_EQ(SelectedName(), "dock");
}

TEST(RunDifferencesStory, KeysGoToTheNodeInTheTickInWhichItDiffers) {
  Driver driver;
  ASSERT_TRUE(ComparePartingRuns(driver));
  const EditorState& state = driver.editor.state();
  ASSERT_FALSE(state.run.comparison.selected);
  const auto& first = state.run.comparison.result->differences[0];
  ASSERT_NE(state.workspace.run()->playhead().tick() + 1, first.first_tick);
  driver.Press('N', kAlt);
  EXPECT_EQ(state.run.comparison.selected, 0U);
  EXPECT_EQ(state.workspace.run()->playhead().tick() + 1, first.first_tick);
}

}  // namespace
}  // namespace coppice::editor
