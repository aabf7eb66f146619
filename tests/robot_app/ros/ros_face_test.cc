#include "robot_app/ros/ros_face.h"

#include <coppice_msgs/Expression.h>
#include <gtest/gtest.h>

#include <mutex>
#include <string>

#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot::adapters {
namespace {

using leaves::Expression;

class RosFaceTest : public testing::Test {
 protected:
  bool Shows(const std::string& expression) {
    return Eventually([&] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return newest_ == expression;
    });
  }

  ros::NodeHandle node_;
  RosFace face_{node_};
  std::mutex mutex_;
  std::string newest_;
  ros::Subscriber subscriber_ = node_.subscribe<coppice_msgs::Expression>(
      "/expression", 10, [this](const coppice_msgs::Expression::ConstPtr& message) {
        const std::lock_guard<std::mutex> lock(mutex_);
        newest_ = message->expression;
      });
};

TEST_F(RosFaceTest, TellsTheLastingExpressionAlsoToThoseWhoComeLater) {
  face_.SetExpression(Expression::SLEEP);
  EXPECT_TRUE(Shows("SLEEP"));
}

TEST_F(RosFaceTest, TellsTheMostImportantOfThoseThatAreHeld) {
  face_.Hold(Expression::SAD);
  face_.Hold(Expression::GREETING);
  EXPECT_TRUE(Shows("SAD"));
  face_.Release(Expression::SAD);
  EXPECT_TRUE(Shows("GREETING"));
}

TEST_F(RosFaceTest, HoldsWhatTwoWantedUntilBothReleaseIt) {
  face_.Hold(Expression::GUIDING);
  face_.Hold(Expression::GUIDING);
  face_.Release(Expression::GUIDING);
  EXPECT_TRUE(Shows("GUIDING"));
  face_.Release(Expression::GUIDING);
  EXPECT_TRUE(Shows("NEUTRAL"));
}

TEST_F(RosFaceTest, TellsItAgainToWhoHasForgottenIt) {
  face_.SetExpression(Expression::SLEEP);
  ASSERT_TRUE(Shows("SLEEP"));
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    newest_.clear();
  }
  EXPECT_TRUE(Shows("SLEEP"));
}

}  // namespace
}  // namespace coppice::robot::adapters
