#include "editor/simulation/simulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "editor/live/run_view.h"

namespace coppice::editor {
namespace {

std::string Text(const std::string& root) {
  return R"(<root BTCPP_format="4"><BehaviorTree ID="Main">)" + root + "</BehaviorTree></root>";
}

class SimulatorTest : public testing::Test {
 protected:
  SimulatorTest() {
    files_.Create("a.xml", Text(R"(<Sequence><Go to="{goal}"/><Say/></Sequence>)"));
    Diagnostics diagnostics;
    view_ = std::make_unique<RunView>(simulator_.Start(files_, "a.xml", "", diagnostics),
                                      std::make_shared<NodeModels>());
  }
  void Update(double seconds) {
    now_ += seconds;
    simulator_.Update(files_, now_);
    view_->Update(HookList(), now_);
  }

  OpenProject files_;
  Simulator simulator_;
  std::unique_ptr<RunView> view_;
  double now_ = 0;
};

TEST_F(SimulatorTest, IsARunLikeThatOfARobot) {
  Update(0);
  EXPECT_EQ(view_->phase(), RunPhase::kSimulation);
  simulator_.get()->Tick(Duration(0));
  Update(0);
  EXPECT_EQ(view_->run().size(), 1U);
  EXPECT_EQ(view_->state().states[1].status, Status::kRunning);
}

TEST_F(SimulatorTest, RunsAtASpeedUntilTheTreeIsDone) {
  EXPECT_TRUE(std::isinf(simulator_.NextUpdateIn(now_)));
  simulator_.SetSpeed(2);
  simulator_.Play();
  Update(0.25);
  EXPECT_EQ(simulator_.get()->ticks(), 5U);
  EXPECT_NEAR(simulator_.NextUpdateIn(now_), 0.05, 1e-6);
  Update(10);
  EXPECT_FALSE(simulator_.is_playing());
  EXPECT_EQ(simulator_.result(), Status::kSuccess);
  EXPECT_EQ(simulator_.get()->now(), std::chrono::milliseconds(2100));
}

TEST_F(SimulatorTest, AnEditIsReloadedALittleLater) {
  simulator_.get()->Tick(Duration(0));
  files_.SetText("a.xml", "Type", Text(R"(<Sequence><Go to="{goal}"/><Wave/></Sequence>)"));
  Update(0.01);
  EXPECT_EQ(simulator_.get()->program()->Id(NodeIndex{2}), "Say");
  EXPECT_GT(simulator_.NextUpdateIn(now_), 0);
  Update(0.2);
  EXPECT_EQ(simulator_.get()->program()->Id(NodeIndex{2}), "Wave");
  EXPECT_EQ(view_->state().states[1].status, Status::kRunning);
}

TEST_F(SimulatorTest, ATextWithErrorsIsSaidAndTheTreeBeforeItGoesOn) {
  files_.SetText("a.xml", "Type", Text("<Inverter/>"));
  Update(0);
  Update(0.2);
  EXPECT_NE(simulator_.problem().find("a.xml:1:"), std::string::npos);
  EXPECT_EQ(simulator_.get()->Tick(Duration(0)), Status::kRunning);
  files_.SetText("a.xml", "Type", Text("<Go/>"));
  Update(0);
  Update(0.2);
  EXPECT_EQ(simulator_.problem(), "");
  EXPECT_EQ(simulator_.get()->program()->nodes.size(), 1U);
}

TEST_F(SimulatorTest, KeysAreWrittenAsOnARobot) {
  std::string error = "?";
  view_->source().Send(WriteKey("", "goal", "3"),
                       [&](const LiveReply& reply) { error = reply.problem(); });
  EXPECT_EQ(error, "");
  simulator_.get()->Tick(Duration(0));
  EXPECT_EQ(simulator_.get()->ValueOf("goal"), "3");
  view_->source().Send(MakeCommand(LiveCommand::Kind::kStepNode),
                       [&](const LiveReply& reply) { error = reply.problem(); });
  EXPECT_NE(error, "");
}

TEST_F(SimulatorTest, EndsWithItsRun) {
  view_.reset();
  EXPECT_EQ(simulator_.get(), nullptr);
  EXPECT_FALSE(simulator_.is_playing());
}

TEST_F(SimulatorTest, ATreeWithErrorsIsNotBegun) {
  files_.Create("b.xml", Text("<Inverter/>"));
  Diagnostics diagnostics;
  EXPECT_FALSE(simulator_.Start(files_, "b.xml", "", diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
  EXPECT_NE(simulator_.get(), nullptr) << "the other one goes on";
}

// A tree on the disk, with scenarios and models beside it.
class SimulatorBesideScenarios : public testing::Test {
 protected:
  SimulatorBesideScenarios() {
    folder_ = testing::TempDir() + "simulator_" +
              testing::UnitTest::GetInstance()->current_test_info()->name() + "/";
    std::filesystem::create_directories(folder_);
    tree_ = Write("a.xml", Text(R"(<Repeat num_cycles="{stops}"><Dry/></Repeat>)"));
    Write(
        "models.xml",
        R"(<root BTCPP_format="4"><TreeNodesModel><Condition ID="Dry"/></TreeNodesModel></root>)");
    WriteScenarios(R"("stops": 3)");
  }
  ~SimulatorBesideScenarios() override { std::filesystem::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ + name) << text;
    return folder_ + name;
  }
  void WriteScenarios(const std::string& set) const {
    Write("a.test.json",
          "{\"tree\": \"a.xml\", \"models\": \"models.xml\",\n\"random\": {\"set\": {" + set +
              "}, \"lasts_ms\": 1000},\n"
              R"("scenarios": [{"name": "a", "steps": [{}]}]})");
  }
  void Start() { run_ = simulator_.Start(files_, tree_, "", diagnostics_); }

  std::string folder_;
  std::string tree_;
  OpenProject files_;
  Simulator simulator_;
  std::unique_ptr<RunSource> run_;
  Diagnostics diagnostics_;
};

TEST_F(SimulatorBesideScenarios, TheirModelsSayWhatLeavesAre) {
  Start();
  ASSERT_TRUE(run_) << diagnostics_.ToString();
  EXPECT_EQ(simulator_.get()->ScriptOf(NodeIndex{1})->duration, Duration(0)) << "a condition";
  EXPECT_FALSE(diagnostics_.has_errors()) << diagnostics_.ToString();
}

TEST_F(SimulatorBesideScenarios, WhatIsWrongWithThemDoesNotKeepTheTreeFromBeingSimulated) {
  Write("a.test.json", "{\n\"random\": 3}");
  Start();
  ASSERT_TRUE(run_);
  EXPECT_NE(diagnostics_.ToString().find("a.test.json:2:11: error: "), std::string::npos)
      << diagnostics_.ToString();
  Diagnostics again;
  EXPECT_FALSE(simulator_.ReadRandomPlay(again));
  EXPECT_TRUE(again.has_errors());
}

TEST_F(SimulatorBesideScenarios, WhatTheySayOfChanceIsReadAnewEveryTime) {
  Start();
  auto play = simulator_.ReadRandomPlay(diagnostics_);
  ASSERT_TRUE(play) << diagnostics_.ToString();
  EXPECT_EQ(play->set[0][0].text, "3");
  EXPECT_EQ(play->where.line, 2U);
  WriteScenarios(R"("stop": 3)");
  EXPECT_FALSE(simulator_.ReadRandomPlay(diagnostics_));
  EXPECT_NE(diagnostics_.ToString().find(R"(a.test.json:2:28: error: the tree has no key "stop")"),
            std::string::npos)
      << diagnostics_.ToString();
  std::filesystem::remove(folder_ + "a.test.json");
  play = simulator_.ReadRandomPlay(diagnostics_);
  ASSERT_TRUE(play);
  EXPECT_EQ(play->where.file, "");
}

TEST_F(SimulatorBesideScenarios, ATreeThatIsBegunAnewPlaysOn) {
  Start();
  Diagnostics diagnostics;
  simulator_.get()->SetChance(Chance{1, *simulator_.ReadRandomPlay(diagnostics)});
  simulator_.SetResult(Status::kSuccess);
  EXPECT_FALSE(simulator_.result()) << "for a second it is begun anew";
  simulator_.Play();
  simulator_.Update(files_, 0);
  simulator_.Update(files_, 30);
  EXPECT_FALSE(simulator_.is_playing());
  EXPECT_TRUE(simulator_.result());
  EXPECT_GE(simulator_.get()->now(), std::chrono::seconds(1));
}

}  // namespace
}  // namespace coppice::editor
