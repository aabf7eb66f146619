#include "robot_app/ros/console_supervisor.h"

#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot {
namespace {

class ConsoleSupervisorTest : public testing::Test {
 protected:
  ConsoleSupervisorTest() {
    harness_.Set("subject", std::string("navigation"));
    harness_.Set("question", std::string("stuck"));
    harness_.Tick();
  }
  bool AnswerLeadsTo(const std::string& text, Status status) {
    std_msgs::String message;
    message.data = text;
    ros::Publisher answers = node_.advertise<std_msgs::String>("/supervisor/answer", 1, true);
    answers.publish(message);
    return Eventually([&] { return harness_.Tick() == status; });
  }

  ros::NodeHandle node_;
  ConsoleSupervisor supervisor_{node_};
  LeafHarness harness_ = LeafHarness::For<AskSupervisor>(std::ref<SupervisorChannel>(supervisor_));
};

TEST_F(ConsoleSupervisorTest, SucceedsWhenTheAnswerIsFixed) {
  EXPECT_TRUE(AnswerLeadsTo("fixed", Status::kSuccess));
}

TEST_F(ConsoleSupervisorTest, FailsWhenTheAnswerIsNotFixed) {
  EXPECT_TRUE(AnswerLeadsTo("not fixed", Status::kFailure));
  EXPECT_EQ(harness_.message(), "the supervisor could not fix it");
}

TEST_F(ConsoleSupervisorTest, TellsThatAWithdrawnQuestionHasSettledItself) {
  testing::internal::CaptureStdout();
  harness_.Halt();
  const std::string out = testing::internal::GetCapturedStdout();
  EXPECT_NE(out.find("needs no help any more"), std::string::npos) << out;
}

TEST_F(ConsoleSupervisorTest, AnswersTheNewestOfSeveralQuestions) {
  LeafHarness second = LeafHarness::For<AskSupervisor>(std::ref<SupervisorChannel>(supervisor_));
  second.Set("subject", std::string("localization"));
  second.Set("question", std::string("lost"));
  second.Tick();
  std_msgs::String message;
  message.data = "fixed";
  ros::Publisher answers = node_.advertise<std_msgs::String>("/supervisor/answer", 1, true);
  answers.publish(message);
  EXPECT_TRUE(Eventually([&] { return second.Tick() == Status::kSuccess; }));
  EXPECT_EQ(harness_.Tick(), Status::kRunning);
}

}  // namespace
}  // namespace coppice::robot
