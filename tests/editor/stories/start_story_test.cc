#include <gtest/gtest.h>

#include <set>

#include "editor/workspace/simulation_editor.h"
#include "editor/workspace/tour.h"
#include "tests/editor/driver.h"
#include "tests/editor/reference_picture.h"

namespace coppice::editor {
namespace {

class StartStory : public testing::Test {
 protected:
  StartStory() { driver_.Frames(); }

  EditorState& state() { return driver_.editor.state(); }
  std::string Title() {
    const TourStep* const step = ShownStep(state());
    return step ? std::string(step->title) : std::string();
  }

  Driver driver_;
};

TEST_F(StartStory, AClickOpensTheExampleOfATree) {
  EXPECT_EQ(CompareWithReference(driver_.editor.Picture(), "story_start"), "");
  ASSERT_TRUE(driver_.Click("start/example_tree"));
  EXPECT_EQ(state().workspace.ShownTreeId(), "Delivery");
  EXPECT_EQ(state().workspace.file()->problems.size(), 0U) << "an example has nothing wrong";
}

TEST_F(StartStory, AClickOpensTheExampleOfARecord) {
  ASSERT_TRUE(driver_.Click("start/example_record"));
  driver_.Frames();
  ASSERT_NE(state().workspace.run(), nullptr);
  EXPECT_GT(state().workspace.run()->run().size(), 10U);
}

TEST_F(StartStory, AClickOpensASimulatedRobotAndItRuns) {
  ASSERT_TRUE(driver_.Click("start/example_robot"));
  driver_.Frames(100);
  ASSERT_TRUE(SimulationEditor(state(), state().now).IsShown());
  const auto& run = state().workspace.run()->run();
  ASSERT_GT(run.size(), 3U);
  std::set<Status> seen;
  for (std::size_t tick = 0; tick < run.size(); ++tick) {
    const Tracks& tracks = run.TracksAt(tick);
    for (NodeIndex node{0}; node < tracks.tree()->nodes.size(); ++node) {
      seen.insert(tracks.LaneOf(node).At(tick));
    }
  }
  EXPECT_EQ(seen.count(Status::kFailure) + seen.count(Status::kSuccess), 2U)
      << "something goes wrong, something well";
}

TEST_F(StartStory, ARecentFileThatIsGoneIsNotOpened) {
  const TemporaryFile there("there.xml", kSmallFile);
  state().recent.files = {"/nowhere/gone.xml", there.path()};
  driver_.Frames();
  ASSERT_TRUE(driver_.Click("start/recent/0"));
  EXPECT_TRUE(state().workspace.files().empty());
  ASSERT_TRUE(driver_.Click("start/recent/1"));
  EXPECT_EQ(state().workspace.files().size(), 1U) << "the others are";
}

TEST_F(StartStory, TheTourGoesOnWhenTheUserDoesWhatItSays) {
  ASSERT_TRUE(driver_.Click("start/tour"));
  driver_.Frames(10);
  EXPECT_EQ(Title(), "The tree");
  ASSERT_TRUE(driver_.Has("tour/item"));
  ASSERT_TRUE(driver_.Click("canvas/Delivery/1.1"));
  driver_.Frames();
  EXPECT_EQ(Title(), "The same as rows");
  driver_.Click("tour/next");
  EXPECT_EQ(Title(), "Everything about the node");
  EXPECT_EQ(CompareWithReference(driver_.editor.Picture(), "story_tour"), "");
  driver_.Press('D');  // disables the node: an edit
  driver_.Frames();
  EXPECT_EQ(Title(), "Nodes to add");
  driver_.Click("tour/back");
  EXPECT_EQ(Title(), "Everything about the node");
}

TEST_F(StartStory, EscEndsTheTour) {
  driver_.Click("start/tour");
  driver_.Frames();
  ASSERT_TRUE(driver_.Has("tour"));
  driver_.Press(kKeyEscape);
  EXPECT_EQ(Title(), "");
  EXPECT_FALSE(driver_.Has("tour"));
}

TEST_F(StartStory, TheTourIsReadToItsEndWithPageDown) {
  driver_.Click("menu/help");
  ASSERT_TRUE(driver_.Click("menu/help.tour"));
  driver_.Frames(8);
  for (std::size_t i = 0; i < TourSteps().size(); ++i) {
    driver_.Frames(4);
    EXPECT_TRUE(driver_.Has("tour/item")) << Title() << " points at nothing";
    EXPECT_TRUE(driver_.Has("tour")) << i;
    driver_.Press(kKeyPageDown);
  }
  EXPECT_EQ(Title(), "");
}

}  // namespace
}  // namespace coppice::editor
