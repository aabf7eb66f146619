#include "robot_app/monitoring/system/remote_answers.h"

#include <gtest/gtest.h>

#include <future>

#include "robot_app/monitoring/system/time_server.h"

namespace coppice::robot::monitoring {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(RemoteAnswers, AreThoseOfTheClocksAndOfTheHosts) {
  TimeServer server("127.0.0.1", 0, seconds(3));
  const RemoteQuestions questions{{{"127.0.0.1", server.port()}}, {{"127.0.0.1", 1}}, seconds(10)};
  auto asked = std::async(std::launch::async, [&] { return AskComputers(questions); });
  while (asked.wait_for(seconds(0)) != std::future_status::ready) server.Work(milliseconds(1));
  const RemoteAnswers answers = asked.get();
  ASSERT_EQ(answers.clocks.size(), 1u);
  EXPECT_NEAR(answers.clocks[0]->offset, 3, 0.5);
  ASSERT_EQ(answers.hosts.size(), 1u);
  EXPECT_TRUE(answers.hosts[0]) << answers.hosts[0].problem();
}

}  // namespace
}  // namespace coppice::robot::monitoring
