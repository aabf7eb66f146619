#include "robot_app/common/service_call.h"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <std_srvs/Trigger.h>

#include "tests/robot_app/ros_environment.h"

namespace coppice::robot {
namespace {

using std_srvs::Trigger;

class ServiceCallTest : public testing::Test {
 protected:
  // A program whose loop stands still: its queue is one that nobody serves.
  void AdvertiseBehind(ros::CallbackQueueInterface* queue) {
    node_.setCallbackQueue(queue);
    const boost::function<bool(Trigger::Request&, Trigger::Response&)> answer =
        [](Trigger::Request&, Trigger::Response& response) {
          response.success = true;
          return true;
        };
    server_ = node_.advertiseService("/help", answer);
  }

  ros::NodeHandle node_;
  ros::ServiceServer server_;
  Trigger service_;
};

TEST_F(ServiceCallTest, BringsTheAnswer) {
  AdvertiseBehind(ros::getGlobalCallbackQueue());
  EXPECT_TRUE(CallService("/help", service_, std::chrono::seconds(60)));
  EXPECT_TRUE(service_.response.success);
}

TEST_F(ServiceCallTest, AHungProgramCostsNoMoreThanTheDeadline) {
  ros::CallbackQueue nobody_serves;
  AdvertiseBehind(&nobody_serves);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(CallService("/help", service_, std::chrono::milliseconds(300)));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(300));
  server_.shutdown();
}

TEST_F(ServiceCallTest, AServiceThatNobodyOffersIsNoAnswer) {
  EXPECT_FALSE(CallService("/nobody", service_));
}

}  // namespace
}  // namespace coppice::robot
