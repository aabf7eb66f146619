// Fifty robots in one window: who needs somebody is seen, and found with a click or a key.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

constexpr int kRobots = 50;
constexpr char kTree[] = R"(<root BTCPP_format="4">
<BehaviorTree ID="Patrol" _fullpath=""><Fallback name="top" _uid="1"><Drive name="Drive" _uid="2"/>
<AskSupervisor name="ask" question="Please open the door." _uid="3"/></Fallback></BehaviorTree>
</root>)";

class ManyRobotsStory : public testing::Test {
 protected:
  ManyRobotsStory() {
    driver_.input.width = 1600;
    driver_.input.height = 1000;
    for (int i = 1; i <= kRobots; ++i) {
      robots_.push_back(driver_.AddRobot(Name(i), kTree));
      robots_.back()->Tick();
    }
    driver_.Frames();
    driver_.editor.state().workspace.ShowRun(0);
    driver_.Frames();
  }
  static std::string Name(int number) { return "sobi-" + std::to_string(number) + ":1667"; }
  std::string Shown() { return driver_.editor.state().workspace.run()->name(); }
  float TopOf(int number) { return driver_.BoxOf("run/robots/" + Name(number)).min.y; }

  void Ask(int number) {
    EventWriter words;
    words.Status(NodeIndex(2), Status::kRunning);
    robots_[static_cast<std::size_t>(number - 1)]->Tick(words.words());
    driver_.Frames();
  }

  Driver driver_;
  std::vector<ScriptedRobot*> robots_;
};

TEST_F(ManyRobotsStory, WhoAsksIsFirstInTheListAndAClickShowsIt) {
  Ask(41);
  ASSERT_TRUE(driver_.Click("strip/robots"));
  driver_.Frames();
  driver_.Picture("many_robots");
  EXPECT_LT(TopOf(41), TopOf(1));
  ASSERT_TRUE(driver_.Click("run/robots/" + Name(41)));
  EXPECT_EQ(Shown(), Name(41));
}

TEST_F(ManyRobotsStory, AKeyListsThem) {
  EXPECT_FALSE(driver_.Has("run/robots/" + Name(1)));
  driver_.Press('O');
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("run/robots/" + Name(1)));
}

TEST_F(ManyRobotsStory, TheSignIsThereOnlyWhileSomebodyIsNeeded) {
  const Color sign = GetPalette(PaletteName::kDark).error;
  EXPECT_EQ(driver_.CountColor(driver_.BoxOf("strip/robots"), sign), 0);
  robots_[20]->Disconnect("no answer");
  driver_.Frames();
  const float broad = driver_.BoxOf("strip/robots").width();
  robots_[20]->Connect();
  driver_.Frames();
  EXPECT_LT(driver_.BoxOf("strip/robots").width(), broad);
}

TEST_F(ManyRobotsStory, TheTabOfTheShownRobotIsAlwaysInSight) {
  for (const std::size_t number : {0, 24, 49}) {
    driver_.editor.state().workspace.ShowRun(number);
    driver_.Frames();
    const Box tab = driver_.BoxOf("strip/" + Shown());
    EXPECT_GT(tab.width(), 50) << number;
    EXPECT_LT(tab.max.x, driver_.BoxOf("strip/robots").min.x) << number;
  }
}

}  // namespace
}  // namespace coppice::editor
