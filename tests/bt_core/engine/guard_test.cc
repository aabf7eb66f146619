// Guards and hooks, while ticking and halting.
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using Names = std::vector<std::string>;
constexpr Status kRunning = Status::kRunning;
constexpr Status kSuccess = Status::kSuccess;
constexpr Status kFailure = Status::kFailure;
constexpr Status kSkipped = Status::kSkipped;

LeafScript Results(std::map<std::string, std::vector<Status>> results) {
  LeafScript script;
  script.results = std::move(results);
  return script;
}

// A leaf "a" with guards; `log` collects the letters of hooks, `x` is set from outside.
class Guards : public ::testing::Test {
 protected:
  void Load(const std::string& attributes, std::vector<Status> results) {
    stage_ = std::make_unique<Stage>(
        Main("<Sequence _onStart=\"log := ''\"><Leaf name=\"a\" " + attributes + "/></Sequence>"),
        Results({{"a", std::move(results)}}));
    SetX(0);
  }
  void SetX(std::int64_t x) { stage_->executor->Writer<std::int64_t>("x").Send(x); }
  Status Tick() { return stage_->executor->Tick(); }
  std::string Log() const {
    const SlotIndex slot = stage_->program->layout.Find(kMainScope, "log");
    const Value& value = stage_->executor->blackboard()[slot].value;
    return value.has_value() ? value.Get<std::string>() : "unset";
  }
  std::unique_ptr<Stage> stage_;
};

struct Decision {
  std::string guard;
  std::int64_t x;
  Status result;
  bool ticked;
};

class EachGuard : public ::testing::TestWithParam<Decision> {};

TEST_P(EachGuard, DecidesOrLetsTheNodeBeTicked) {
  const Decision& decision = GetParam();
  Stage stage(Main("<Leaf name=\"a\" " + decision.guard + "=\"x == 1\"/>"));
  stage.executor->Writer<std::int64_t>("x").Send(decision.x);
  EXPECT_EQ(stage.executor->Tick(), decision.result);
  EXPECT_EQ(stage.TakeEvents(), decision.ticked ? Names{"start a"} : Names{});
}

INSTANTIATE_TEST_SUITE_P(Guards, EachGuard,
                         ::testing::Values(Decision{"_failureIf", 1, kFailure, false},
                                           Decision{"_failureIf", 0, kSuccess, true},
                                           Decision{"_successIf", 1, kSuccess, false},
                                           Decision{"_successIf", 0, kSuccess, true},
                                           Decision{"_skipIf", 1, kSkipped, false},
                                           Decision{"_skipIf", 0, kSuccess, true},
                                           Decision{"_onlyIf", 1, kSuccess, true},
                                           Decision{"_onlyIf", 0, kSkipped, false},
                                           Decision{"_while", 1, kSuccess, true},
                                           Decision{"_while", 0, kSkipped, false}),
                         [](const auto& info) {
                           return info.param.guard.substr(1) + (info.param.x ? "True" : "False");
                         });

TEST_F(Guards, AreNotAskedWhileTheNodeRuns) {
  Load("_failureIf=\"x == 1\" _successIf=\"x == 1\" _skipIf=\"x == 1\" _onlyIf=\"x == 0\"",
       {kRunning});
  EXPECT_EQ(Tick(), kRunning);
  SetX(1);
  EXPECT_EQ(Tick(), kRunning);
}

TEST_F(Guards, WhileIsAskedInEveryTickAndHaltsTheNode) {
  Load("_while=\"x == 0\" _onHalted=\"log += 'h'\"", {kRunning});
  EXPECT_EQ(Tick(), kRunning);
  SetX(1);
  EXPECT_EQ(Tick(), kSkipped);
  EXPECT_EQ(stage_->TakeEvents(), (Names{"start a", "halt a"}));
  EXPECT_EQ(Log(), "h");
}

TEST_F(Guards, TheFirstThatDecidesWins) {
  Load("_skipIf=\"x == 0\" _failureIf=\"x == 0\" _successIf=\"x == 0\"", {kSuccess});
  EXPECT_EQ(Tick(), kFailure);
}

TEST_F(Guards, HooksOfAnActivationThatSucceeds) {
  Load(
      "_onStart=\"log += 's'\" _onSuccess=\"log += 'S'\" _onFailure=\"log += 'F'\" "
      "_post=\"log += 'p'\" _onHalted=\"log += 'h'\"",
      {kRunning, kRunning, kSuccess});
  Tick();
  Tick();
  EXPECT_EQ(Log(), "s");
  EXPECT_EQ(Tick(), kSuccess);
  EXPECT_EQ(Log(), "sSp");
}

TEST_F(Guards, HooksOfAnActivationThatFails) {
  Load(
      "_onStart=\"log += 's'\" _onSuccess=\"log += 'S'\" _onFailure=\"log += 'F'\" "
      "_post=\"log += 'p'\"",
      {kFailure});
  EXPECT_EQ(Tick(), kFailure);
  EXPECT_EQ(Log(), "sFp");
}

TEST_F(Guards, HooksOfAHaltedActivation) {
  Load("_onSuccess=\"log += 'S'\" _post=\"log += 'p'\" _onHalted=\"log += 'h'\"", {kRunning});
  Tick();
  stage_->executor->Halt();
  EXPECT_EQ(Log(), "h");
  stage_->executor->Halt();
  EXPECT_EQ(Log(), "h");
}

TEST_F(Guards, AGuardsResultHasItsHooksButDoesNotStartTheNode) {
  Load(
      "_successIf=\"x == 0\" _onStart=\"log += 's'\" _onSuccess=\"log += 'S'\" "
      "_post=\"log += 'p'\"",
      {kFailure});
  EXPECT_EQ(Tick(), kSuccess);
  EXPECT_EQ(Log(), "Sp");
}

TEST_F(Guards, ASkippedNodeHasNoHooks) {
  Load(
      "_skipIf=\"x == 0\" _onStart=\"log += 's'\" _onSuccess=\"log += 'S'\" "
      "_onFailure=\"log += 'F'\" _post=\"log += 'p'\" _onHalted=\"log += 'h'\"",
      {kFailure});
  EXPECT_EQ(Tick(), kSkipped);
  EXPECT_EQ(Log(), "");
}

TEST(Guard, HaltHooksComeFromTheInsideOut) {
  Stage stage(Main("<Sequence _onStart=\"log := ''\" _onHalted=\"log += 'outer'\">"
                   "<Inverter _onHalted=\"log += 'inner '\"><Leaf name=\"a\"/></Inverter>"
                   "</Sequence>"),
              Results({{"a", {kRunning}}}));
  stage.executor->Tick();
  stage.executor->Halt();
  const SlotIndex log = stage.program->layout.Find(kMainScope, "log");
  EXPECT_EQ(stage.executor->blackboard()[log].value.Get<std::string>(), "inner outer");
}

std::string HooksOf(const Stage& stage) {
  const SlotIndex log = stage.program->layout.Find(kMainScope, "log");
  return stage.executor->blackboard()[log].value.Get<std::string>();
}

TEST(Guard, ASkippedLeafThatHadBegunIsToldOfItsHaltByTheHook) {
  Stage stage(Main("<Sequence _onStart=\"log := ''\">"
                   "<Leaf name=\"a\" _onStart=\"log += 's'\" _onHalted=\"log += 'h'\"/>"
                   "<Leaf name=\"b\"/></Sequence>"),
              Results({{"a", {kRunning, kSkipped}}, {"b", {kFailure}}}));
  stage.executor->Tick();
  EXPECT_EQ(stage.executor->Tick(), kFailure);
  EXPECT_EQ(stage.TakeEvents(), (Names{"start a", "tick a", "start b", "halt a"}));
  EXPECT_EQ(HooksOf(stage), "sh");
}

TEST(Guard, HooksOfSkippedNodesComeFromTheInsideOut) {
  Stage stage(Main("<Sequence _onStart=\"log := ''\">"
                   "<Delay delay_msec=\"0\" _onHalted=\"log += 'outer'\">"
                   "<Leaf name=\"a\" _onHalted=\"log += 'inner '\"/></Delay>"
                   "<Leaf name=\"b\"/></Sequence>"),
              Results({{"a", {kRunning, kSkipped}}, {"b", {kFailure}}}));
  stage.executor->Tick();
  EXPECT_EQ(stage.executor->Tick(), kFailure);
  EXPECT_EQ(HooksOf(stage), "inner outer");
}

TEST(Guard, WhileHaltsWhatASkippedNodeHasBegun) {
  Stage stage(Main("<Leaf name=\"a\" _while=\"go\" _onHalted=\"log += 'h'\"/>"),
              Results({{"a", {kRunning, kSkipped}}}));
  stage.executor->Writer<std::string>("log").Send("");
  const Sender<bool> go = stage.executor->Writer<bool>("go");
  go.Send(true);
  stage.executor->Tick();
  stage.executor->Tick();
  EXPECT_EQ(HooksOf(stage), "");
  go.Send(false);
  EXPECT_EQ(stage.executor->Tick(), kSkipped);
  EXPECT_EQ(stage.TakeEvents(), (Names{"start a", "tick a", "halt a"}));
  EXPECT_EQ(HooksOf(stage), "h");
}

TEST(Guard, AScriptThatCannotRunFailsTheNodeWithAMessage) {
  Stage stage(Main("<Leaf name=\"a\" _skipIf=\"nobody > 3\"/>"));
  const KeepingSink& sink = stage.Listen();
  EXPECT_EQ(stage.executor->Tick(), kFailure);
  ASSERT_EQ(sink.ticks[0].messages.size(), 1U);
  EXPECT_NE(sink.ticks[0].messages[0].text.find("nobody"), std::string::npos);
}

TEST(Guard, AHookThatCannotRunFailsTheNode) {
  Stage stage(Main("<Leaf name=\"a\" _onSuccess=\"nobody += 3\"/>"));
  EXPECT_EQ(stage.executor->Tick(), kFailure);
}

TEST(Guard, InASubTreeNamesMeanKeysOfTheSubTree) {
  Stage stage(
      Root("<BehaviorTree ID=\"Main\"><SubTree ID=\"Part\" limit=\"{outer}\"/></BehaviorTree>"
           "<BehaviorTree ID=\"Part\"><Leaf name=\"a\" _skipIf=\"limit &gt; 3\"/>"
           "</BehaviorTree>"));
  stage.executor->Writer<std::int64_t>("outer").Send(4);
  EXPECT_EQ(stage.executor->Tick(), kSkipped);
}

TEST(Guard, OfASubTreeGuardsAllOfIt) {
  Stage stage(Root("<BehaviorTree ID=\"Main\"><SubTree ID=\"Part\" _while=\"go\"/></BehaviorTree>"
                   "<BehaviorTree ID=\"Part\"><Leaf name=\"a\"/></BehaviorTree>"),
              Results({{"a", {kRunning}}}));
  const Sender<bool> go = stage.executor->Writer<bool>("go");
  go.Send(true);
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  go.Send(false);
  EXPECT_EQ(stage.executor->Tick(), kSkipped);
  EXPECT_EQ(stage.TakeEvents(), (Names{"start a", "halt a"}));
}

}  // namespace
}  // namespace coppice
