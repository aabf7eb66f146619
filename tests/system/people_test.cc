// The robot among people, in real time: who walks by is seen by lidar and cameras, followed and
// spoken to; and a perception that dies is a fault that is recovered from.
#include <coppice_msgs/People.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

#include <cmath>
#include <csignal>
#include <memory>

#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/support/folders.h"
#include "tests/system/fault_case.h"

namespace coppice::robot {
namespace {

constexpr double kPatience = 120;  // s, wall

// In the entrance hall, where two people walk about.
RigOptions Options() {
  RigOptions options;
  options.name = "people";
  options.start = "44.5 -1.8 1.5708";
  options.variables = {{"speed", "1"},
                       {"seed", "16"},
                       {"perception", "yes"},
                       {"application", SourceFolder() + "/tests/system/trees/greet.xml"}};
  return options;
}

class People : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    rig_ = std::make_unique<RobotRig>(Options());
    ASSERT_TRUE(rig_->Start());
  }
  static void TearDownTestSuite() { rig_.reset(); }

  static std::unique_ptr<RobotRig> rig_;
};

std::unique_ptr<RobotRig> People::rig_;

bool IsAnybodyWalking(const coppice_msgs::People& people) {
  for (const coppice_msgs::Person& person : people.people) {
    const double speed = std::hypot(person.velocity.x, person.velocity.y);
    if (person.known_for > 1 && speed > 0.4 && speed < 2) return true;
  }
  return false;
}

TEST_F(People, WhoWalksByIsSeenFollowedAndSpokenTo) {
  ros::NodeHandle node;
  Latest<coppice_msgs::People> people(node, "/people");
  Latest<std_msgs::String> speech(node, "/speech");
  EXPECT_TRUE(
      Eventually([&] { return people.get() && IsAnybodyWalking(*people.get()); }, kPatience));
  EXPECT_TRUE(Eventually([&] { return speech.get() && speech.get()->data == "Can I help you?"; },
                         kPatience))
      << (speech.get() ? speech.get()->data : "it never spoke");
}

TEST_F(People, ThoseWhomACameraSeesAreSaidToBeSeenByIt) {
  ros::NodeHandle node;
  Latest<coppice_msgs::People> people(node, "/people");
  const auto by_both = [&] {
    const auto newest = people.get();
    if (!newest) return false;
    for (const coppice_msgs::Person& person : newest->people) {
      constexpr int kBoth = coppice_msgs::Person::LIDAR | coppice_msgs::Person::CAMERA;
      if ((person.seen_by & kBoth) == kBoth) return true;
    }
    return false;
  };
  EXPECT_TRUE(Eventually(by_both, kPatience));
}

TEST_F(People, ATrackerThatHangsIsRestarted) {
  FaultCase fault(*rig_, "people tracker hung", "SIGSTOP to `/people_tracker`");
  ASSERT_TRUE(rig_->Signal("people_tracker", SIGSTOP));
  fault.ExpectRestartBegun("people_tracker",
                           10);  // whoever sees it first: who pings, or who listens
  fault.ExpectRestarted("people_tracker");
  fault.ExpectNominal();
  fault.ExpectOnlyRestarted({"people_tracker"});
  fault.ExpectNobodyAsked();
}

TEST_F(People, ASonarThatGoesBlindIsSeen) {
  FaultCase fault(*rig_, "sonar blind", "`blind_topic /sonar/front` for 8 s");
  ASSERT_TRUE(rig_->Inject("blind_topic", "/sonar/front", 0, 8));
  fault.ExpectLevel("topic", "/sonar/front", 2, 8);
}

}  // namespace
}  // namespace coppice::robot
