#include "robot_app/ros/ros_recovery_log.h"

#include <coppice_msgs/RecoveryEvent.h>
#include <gtest/gtest.h>

#include <mutex>

#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot::adapters {
namespace {

using Message = coppice_msgs::RecoveryEvent;

class RosRecoveryLogTest : public testing::Test {
 protected:
  RosRecoveryLogTest()
      : subscriber_(node_.subscribe<Message>("/recovery/events", 100,
                                             [this](const Message::ConstPtr& message) {
                                               const std::lock_guard<std::mutex> lock(mutex_);
                                               messages_.push_back(*message);
                                             })) {}
  bool HasHeard(std::size_t count) {
    return Eventually([&] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return messages_.size() >= count;
    });
  }
  bool IsConnected() {
    return Eventually([this] { return subscriber_.getNumPublishers() > 0; });
  }

  SimulatedClock clock_{std::chrono::seconds(100)};
  ros::NodeHandle node_;
  std::mutex mutex_;
  std::vector<Message> messages_;
  ros::Subscriber subscriber_;
  RosRecoveryLog log_{node_, clock_};
};

TEST_F(RosRecoveryLogTest, PublishesWhatIsDoneAndLaterWhetherItHelped) {
  ASSERT_TRUE(IsConnected());
  log_.Record({"wait and retry", "navigation", leaves::RecoveryPhase::kBegun, 2,
               Time(std::chrono::seconds(100)), leaves::Pose2D{1, 2, 3}, ""});
  log_.Record({"wait and retry", "navigation", leaves::RecoveryPhase::kSucceeded, 2,
               Time(std::chrono::seconds(120)), std::nullopt, ""});
  ASSERT_TRUE(HasHeard(2));
  EXPECT_EQ(messages_[0].phase, Message::BEGUN);
  EXPECT_EQ(messages_[0].attempt, 2u);
  EXPECT_EQ(messages_[0].header.frame_id, "map");
  EXPECT_EQ(messages_[0].y, 2);
  EXPECT_EQ(messages_[1].phase, Message::SUCCEEDED);
  EXPECT_EQ(messages_[1].header.frame_id, "");
  clock_.Advance(std::chrono::seconds(100));
  ASSERT_TRUE(HasHeard(3));
  EXPECT_EQ(messages_[2].phase, Message::HELPED);
  EXPECT_EQ(messages_[2].subject, "navigation");
}

}  // namespace
}  // namespace coppice::robot::adapters
