#include "robot_app/processes/person_calls.h"

#include <gmock/gmock.h>

namespace coppice::robot::processes {
namespace {

using testing::ElementsAre;

class Telephone : public ProcessLauncher {
 public:
  Expected<int> Start(const ProcessConfig& config) override {
    calls.push_back(config.command);
    if (broken) return Problem{"no such program"};
    return ++last_pid;
  }
  void Signal(int, int) override {}
  Outcome ClearState(const ProcessConfig&) override { return {}; }
  bool IsConnected(int) const override { return true; }

  std::vector<std::vector<std::string>> calls;
  bool broken = false;
  int last_pid = 0;
};

class PersonCallsTest : public testing::Test {
 protected:
  Telephone telephone_;
  PersonCalls calls_{{"call", "--now"}, telephone_};
  Time now_{std::chrono::seconds(100)};
};

TEST_F(PersonCallsTest, RunsTheCommandWithTheMessageOneAfterTheOther) {
  calls_.Add("first");
  calls_.Add("second");
  calls_.Step(now_);
  calls_.Step(now_);
  EXPECT_THAT(telephone_.calls, ElementsAre(ElementsAre("call", "--now", "first")));
  calls_.OnExit(1, 0, now_);
  calls_.Step(now_);
  EXPECT_THAT(telephone_.calls.back(), ElementsAre("call", "--now", "second"));
  EXPECT_FALSE(calls_.idle());
  calls_.OnExit(99, 0, now_);  // somebody else
  calls_.OnExit(2, 0, now_);
  EXPECT_TRUE(calls_.idle());
}

TEST_F(PersonCallsTest, TriesAgainAfterAFailureButNotForEver) {
  calls_.Add("help");
  calls_.Step(now_);
  calls_.OnExit(1, 1 << 8, now_);
  calls_.Step(now_ + PersonCalls::kPause - Duration(1));
  EXPECT_EQ(telephone_.calls.size(), 1u);
  telephone_.broken = true;
  for (int i = 0; i < 100; ++i) calls_.Step(now_ += PersonCalls::kPause);
  EXPECT_EQ(telephone_.calls.size(), static_cast<std::size_t>(PersonCalls::kTries));
  EXPECT_TRUE(calls_.idle());
}

TEST_F(PersonCallsTest, WithoutACommandNothingIsDone) {
  PersonCalls silent({}, telephone_);
  silent.Add("help");
  EXPECT_TRUE(silent.idle());
}

}  // namespace
}  // namespace coppice::robot::processes
