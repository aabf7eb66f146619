#include "robot_app/monitoring/system/remote_watch.h"

#include <gtest/gtest.h>

#include <functional>

#include "robot_app/monitoring/system/time_server.h"

namespace coppice::robot::monitoring {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class RemoteWatchTest : public testing::Test {
 protected:
  RemoteQuestions Questions() {
    RemoteQuestions questions;
    questions.clocks = {{"127.0.0.1", server_.port()}};
    questions.hosts = {{"127.0.0.1", 1}};
    questions.period = milliseconds(10);
    questions.deadline = seconds(10);
    return questions;
  }
  // The next answers, while our server works; nothing after 10 s.
  std::optional<RemoteAnswers> Next() {
    const Deadline deadline(seconds(10));
    while (!deadline.has_passed()) {
      if (auto answers = remote_.Take()) return answers;
      server_.Work(milliseconds(1));
    }
    return std::nullopt;
  }

  TimeServer server_{"127.0.0.1", 0, seconds(3)};
  RemoteWatch remote_;
};

TEST_F(RemoteWatchTest, AsksAgainAndAgain) {
  remote_.Ask(Questions());
  for (int round = 0; round < 3; ++round) {
    const auto answers = Next();
    ASSERT_TRUE(answers.has_value());
    ASSERT_EQ(answers->clocks.size(), 1u);
    EXPECT_NEAR(answers->clocks[0]->offset, 3, 0.5);
    EXPECT_TRUE(answers->hosts.at(0)) << answers->hosts[0].problem();
  }
}

TEST_F(RemoteWatchTest, NewQuestionsReplaceTheOldOnes) {
  remote_.Ask(Questions());
  ASSERT_TRUE(Next().has_value());
  RemoteQuestions two = Questions();
  two.clocks.clear();
  two.hosts.push_back(two.hosts[0]);
  remote_.Ask(two);
  const auto answers = Next();
  ASSERT_TRUE(answers.has_value());
  EXPECT_TRUE(answers->clocks.empty());
  EXPECT_EQ(answers->hosts.size(), 2u);
  remote_.Ask({});
  EXPECT_FALSE(remote_.Take().has_value());
}

}  // namespace
}  // namespace coppice::robot::monitoring
