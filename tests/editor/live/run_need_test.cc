#include "editor/live/run_need.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using Level = RunNeed::Level;

constexpr char kAskingTree[] = R"(<root BTCPP_format="4">
<BehaviorTree ID="Main" _fullpath=""><Fallback name="top" _uid="1">
 <Drive name="Drive" _uid="2"/>
 <AskSupervisor name="ask" subject="door" question="Please open the door." _uid="3"/>
 <CallNurse name="call" question="{words}" _uid="4"/></Fallback></BehaviorTree>
<TreeNodesModel><Action ID="Drive"/><Action ID="CallNurse">
 <input_port name="question" type="string"/>
 <MetadataFields><Metadata asks="people"/></MetadataFields></Action></TreeNodesModel></root>)";

class RunNeedTest : public testing::Test {
 protected:
  RunNeedTest() : robot_(driver_.AddRobot("one:1", kAskingTree)) { Tick(); }

  void Tick(const EventWords& words = {}) {
    robot_->Tick(words);
    driver_.Frames(1);
  }
  // In a tick of its own; nodes are counted from 0, the root.
  void Change(std::uint32_t node, Status to) {
    EventWriter words;
    to == Status::kIdle ? words.Reset(NodeIndex(node)) : words.Status(NodeIndex(node), to);
    Tick(words.words());
  }
  RunNeed Need() { return NeedOf(*driver_.editor.state().workspace.run()); }

  Driver driver_;
  ScriptedRobot* const robot_;
};

TEST_F(RunNeedTest, OneThatTicksNeedsNobody) {
  EXPECT_EQ(Need().level, Level::kNone);
  EXPECT_EQ(Need().why, "");
}

TEST_F(RunNeedTest, OneThatAsksSaysWhat) {
  Change(2, Status::kRunning);
  EXPECT_EQ(Need().level, Level::kCome);
  EXPECT_EQ(Need().why, "asks: Please open the door.");
  Change(2, Status::kSuccess);
  EXPECT_EQ(Need().level, Level::kNone) << "somebody has come";
}

TEST_F(RunNeedTest, ALeafThatFailsUntilSomebodyComesAsksToo) {
  Change(2, Status::kFailure);
  EXPECT_EQ(Need().level, Level::kCome);
  Change(2, Status::kIdle);
  EXPECT_EQ(Need().level, Level::kNone);
}

TEST_F(RunNeedTest, ATypeWhoseModelSaysThatItAsksPeopleIsKnown) {
  Change(3, Status::kRunning);
  EXPECT_EQ(Need().level, Level::kCome);
  EXPECT_EQ(Need().why, "asks: call") << "its words are in a key";
}

TEST_F(RunNeedTest, ItIsAskedNowWhateverTickIsShown) {
  Tick();
  Change(2, Status::kRunning);
  driver_.editor.state().workspace.run()->playhead().GoToTick(0);
  driver_.Frames();
  EXPECT_EQ(Need().level, Level::kCome);
}

TEST_F(RunNeedTest, OneThatStoppedAnsweringNeedsSomebody) {
  robot_->Disconnect("no answer");
  driver_.Frames();
  EXPECT_EQ(Need().level, Level::kCome);
  EXPECT_EQ(Need().why, "does not answer: no answer");
}

TEST_F(RunNeedTest, OneThatStandsAtABreakpointShouldBeLookedAt) {
  robot_->Stop(NodeIndex(1));
  driver_.Frames();
  EXPECT_EQ(Need().level, Level::kLook);
  EXPECT_NE(Need().why.find("PAUSED before"), std::string::npos);
}

TEST_F(RunNeedTest, OneWhoseTreeHasEndedWithFailureShouldBeLookedAt) {
  robot_->Set(1, Status::kFailure);
  Tick();
  driver_.Frames(200);  // no tick comes any more
  EXPECT_EQ(Need().level, Level::kLook);
  EXPECT_EQ(Need().why, "its tree has ended with FAILURE");
}

}  // namespace
}  // namespace coppice::editor
