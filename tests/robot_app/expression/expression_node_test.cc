// The program coppice-expression over ROS.
#include <coppice_msgs/Answer.h>
#include <coppice_msgs/Expression.h>
#include <coppice_msgs/HelpRequests.h>
#include <coppice_msgs/Lights.h>
#include <coppice_msgs/SpeechState.h>
#include <gtest/gtest.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/String.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <functional>

#include "robot_app/common/child_process.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/robot_app/processes/temporary.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/support/folders.h"

namespace coppice::robot::expression {
namespace {

class ExpressionNodeTest : public testing::Test {
 protected:
  // Sends it until the face shows that.
  template <typename Message>
  bool Leads(const ros::Publisher& publisher, const Message& message, const std::string& shown) {
    return Eventually([&] {
      publisher.publish(message);
      return shown_.get() && shown_.get()->data == shown;
    });
  }
  static coppice_msgs::Expression Wish(const std::string& owner, const std::string& expression) {
    coppice_msgs::Expression wish;
    wish.owner = owner;
    wish.expression = expression;
    return wish;
  }
  bool EarsAre(const std::function<bool(double angle)>& right) {
    return Eventually([&] {
      const auto state = joints_.get();
      return state && state->name[0] == "left_ear_joint" && right(state->position[0]) &&
             right(state->position[1]);
    });
  }

  ros::NodeHandle node_;
  ros::Publisher wishes_ = node_.advertise<coppice_msgs::Expression>("/expression", 10);
  ros::Publisher speech_ = node_.advertise<coppice_msgs::SpeechState>("/speech/state", 10);
  ros::Publisher answers_ = node_.advertise<coppice_msgs::Answer>("/speech/answer", 10);
  ros::Publisher requests_ =
      node_.advertise<coppice_msgs::HelpRequests>("/assistance/requests", 10);
  Latest<std_msgs::String> shown_{node_, "/face/expression"};
  Latest<sensor_msgs::Image> image_{node_, "/face/image"};
  Latest<coppice_msgs::Lights> lights_{node_, "/face/lights"};
  Latest<visualization_msgs::MarkerArray> strips_{node_, "/face/light_markers"};
  Latest<sensor_msgs::JointState> joints_{node_, "/joint_states"};
  ChildProcess program_{{BinaryFolder() + "/bin/coppice-expression"},
                        processes::Temporary("expression.log")};
};

TEST_F(ExpressionNodeTest, ShowsAPictureOfTheMatrix) {
  ASSERT_TRUE(Eventually([&] { return image_.get() != nullptr; }));
  EXPECT_EQ(image_.get()->width, 64u);
  EXPECT_EQ(image_.get()->height, 32u);
  EXPECT_EQ(image_.get()->encoding, "rgb8");
  EXPECT_EQ(image_.get()->data.size(), 64u * 32 * 3);
}

TEST_F(ExpressionNodeTest, ListensInGreenWithEarsForward) {
  coppice_msgs::SpeechState state;
  state.hearing = true;
  ASSERT_TRUE(Leads(speech_, state, "LISTENING"));
  EXPECT_TRUE(EarsAre([](double angle) { return angle > 1; }));
  EXPECT_TRUE(Eventually([&] { return lights_.get() && lights_.get()->ears.g > 0.3; }));
  EXPECT_EQ(lights_.get()->ears.r, 0);
}

TEST_F(ExpressionNodeTest, DrawsTheStripsOfAllLimbsForRviz) {
  coppice_msgs::SpeechState state;
  state.hearing = true;
  ASSERT_TRUE(Leads(speech_, state, "LISTENING"));
  EXPECT_TRUE(Eventually([&] {
    const auto strips = strips_.get();
    return strips && strips->markers.size() == 4 && strips->markers[0].color.g > 0.3;
  }));
  const auto strips = strips_.get();
  for (const auto& strip : strips->markers) {
    EXPECT_EQ(strip.pose.position.y > 0, strip.header.frame_id.find("left") == 0)
        << strip.header.frame_id;
  }
}

TEST_F(ExpressionNodeTest, LowersItsEarsWhenItCannotAnswer) {
  coppice_msgs::Answer answer;
  answer.mood = coppice_msgs::Answer::UNKNOWN;
  ASSERT_TRUE(Leads(answers_, answer, "SAD"));
  EXPECT_TRUE(EarsAre([](double angle) { return angle < -1; }));
}

TEST_F(ExpressionNodeTest, AsksForHelpAsLongAsARequestIsOpen) {
  coppice_msgs::HelpRequests requests;
  requests.requests.resize(1);
  ASSERT_TRUE(Leads(requests_, requests, "ASKING_FOR_HELP"));
  requests.requests[0].state = coppice_msgs::HelpRequest::FIXED;
  EXPECT_TRUE(Leads(requests_, requests, "NEUTRAL"));
}

TEST_F(ExpressionNodeTest, ShowsAnErrorWhenTheTreesFallSilent) {
  ASSERT_TRUE(Leads(wishes_, Wish("trees", "SLEEP"), "SLEEP"));
  EXPECT_TRUE(Eventually([&] { return shown_.get()->data == "ERROR"; }));
}

TEST_F(ExpressionNodeTest, GoesOnAfterAnExpressionThatThereIsNot) {
  ASSERT_TRUE(Leads(wishes_, Wish("tablet", "GREETING"), "GREETING"));
  wishes_.publish(Wish("tablet", "SMILING"));
  EXPECT_TRUE(Leads(wishes_, Wish("tablet", "LISTENING"), "LISTENING"));
}

}  // namespace
}  // namespace coppice::robot::expression
