#include "editor/live/run_log.h"

#include <gtest/gtest.h>

#include "tests/editor/timeline/executed_run.h"

namespace coppice::editor {
namespace {

// Two leaves in turn; `count` counts the ticks of "drive".
constexpr char kTrees[] = R"(<BehaviorTree ID="Main"><Sequence name="round">
  <Is as="open" name="door"/><SubTree ID="Pass" name="pass" steps="{all_steps}"/>
  </Sequence></BehaviorTree>
  <BehaviorTree ID="Pass"><Do as="drive" name="drive" count="{steps}"/></BehaviorTree>)";

class RunLogTest : public testing::Test {
 protected:
  RunLogTest() {
    tree_.results["drive"] = Status::kRunning;
    Ticks(3);
    tree_.results["drive"] = Status::kSuccess;
    Ticks(1);
    tree_.results["drive"] = Status::kFailure;
    Ticks(2);
  }
  void Ticks(int count) {
    for (int i = 0; i < count; ++i) tree_.Tick();
  }
  void Add(const std::string& path, const std::string& typed) {
    LogPoint point;
    point.path = path;
    EXPECT_EQ(ReadLogPoint(typed, point).problem(), "");
    points_.Add(point);
    log_.Update(run_, "robot:1", points_);
  }
  std::string Lines() const {
    std::string text;
    for (const LogLine& line : log_.lines()) {
      text += std::to_string(line.tick) + " " + ToString(line.status) + " " + line.text + "\n";
    }
    return text;
  }

  editor::Run run_;
  ExecutedTree tree_{kTrees};
  Follow follow_{tree_.executor, run_};
  LogPoints points_;
  RunLog log_;
};

TEST_F(RunLogTest, WritesWhenTheNodeBeginsAndWhenItReturns) {
  Add("pass/drive", "step {count} of {steps}");
  EXPECT_EQ(Lines(),
            "0 RUNNING step 1 of 1\n"
            "3 SUCCESS step 4 of 4\n"
            "4 FAILURE step 5 of 5\n"
            "5 FAILURE step 6 of 6\n")
      << "also what happened before it was there";
  Ticks(1);
  log_.Update(run_, "robot:1", points_);
  EXPECT_EQ(log_.lines().size(), 5U) << "and what comes";
  EXPECT_EQ(log_.HitsOf(points_.all()[0].number), 5U);
}

TEST_F(RunLogTest, AConditionAndAHitCountNarrowItDown) {
  Add("pass/drive", "{nothing} if steps > 3 #2");
  EXPECT_EQ(Lines(), "4 FAILURE ?\n5 FAILURE ?\n") << "of three hits the first is left out";
  EXPECT_EQ(log_.HitsOf(points_.all()[0].number), 3U);
}

TEST_F(RunLogTest, AConditionThatCannotBeComputedIsSaid) {
  Add("pass/drive", "a if stepz > 3");
  EXPECT_TRUE(log_.lines().empty());
  EXPECT_NE(log_.ProblemOf(points_.all()[0].number).find("stepz"), std::string::npos);
}

TEST_F(RunLogTest, LooksAtALongRunInPieces) {
  Ticks(100);
  LogPoint point;
  point.path = "pass/drive";
  points_.Add(point);
  log_.Update(run_, "robot:1", points_, 50);
  EXPECT_TRUE(log_.is_behind(run_));
  while (log_.is_behind(run_)) log_.Update(run_, "robot:1", points_, 50);
  EXPECT_EQ(log_.lines().back().tick, run_.size() - 1);
}

TEST_F(RunLogTest, OtherRunsAndDisabledLogPointsWriteNothing) {
  LogPoint point;
  point.path = "pass/drive";
  point.run = "robot:2";
  points_.Add(point);
  point.run = "";
  point.enabled = false;
  points_.Add(point);
  log_.Update(run_, "robot:1", points_);
  EXPECT_TRUE(log_.lines().empty());
  EXPECT_FALSE(log_.is_behind(run_));
}

TEST_F(RunLogTest, KeepsTheNewestLines) {
  Ticks(static_cast<int>(RunLog::kMostLines) + 10);
  Add("pass/drive", "");
  while (log_.is_behind(run_)) log_.Update(run_, "robot:1", points_);
  EXPECT_EQ(log_.lines().size(), RunLog::kMostLines);
  EXPECT_EQ(log_.lines().back().tick, run_.size() - 1);
}

}  // namespace
}  // namespace coppice::editor
