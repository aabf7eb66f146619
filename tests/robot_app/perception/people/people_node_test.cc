// coppice-people with the simulator over ROS.
#include <coppice_msgs/People.h>
#include <coppice_msgs/Sightings.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseArray.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>

#include "robot_app/common/child_process.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/robot_app/processes/temporary.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/robot_app/text_of.h"
#include "tests/support/folders.h"

namespace coppice::robot::perception {
namespace {

using processes::Temporary;
using testing::HasSubstr;

constexpr double kPatience = 30;  // wall time [s]
const std::string kPrograms = BinaryFolder() + "/bin/";

class PeopleNodeTest : public testing::Test {
 protected:
  // In the entrance hall, where two people walk about.
  void StartSimulator() {
    ros::param::set("/use_sim_time", true);  // before anybody starts
    simulator_ =
        ChildProcess({kPrograms + "coppice-simulator", "_start:=44 0 0", "_localization:=true"},
                     Temporary("simulator.log"));
  }
  void StartPeople(const std::vector<std::string>& arguments = {}) {
    std::vector<std::string> command{kPrograms + "coppice-people"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    people_program_ = ChildProcess(command, Temporary("people.log"));
  }
  std::string Diagnosis() const {
    const auto message = diagnostics_.get();
    return message && !message->status.empty() ? message->status[0].message : "";
  }

  ros::NodeHandle node_;
  Latest<coppice_msgs::People> people_{node_, "/people"};
  Latest<diagnostic_msgs::DiagnosticArray> diagnostics_{node_, "/diagnostics"};
  ChildProcess simulator_;
  ChildProcess people_program_;
};

TEST_F(PeopleNodeTest, WhoWalksByIsFollowed) {
  Latest<visualization_msgs::MarkerArray> markers(node_, "/people/markers");
  StartSimulator();
  StartPeople({"_frame:=map"});
  const auto somebody_walks = [&] {
    const auto people = people_.get();
    if (!people) return false;
    for (const auto& person : people->people) {
      const bool is_in_hall = person.position.x > 39.5 && std::abs(person.position.y) < 6;
      const double speed = std::hypot(person.velocity.x, person.velocity.y);
      if (is_in_hall && person.known_for > 1 && speed > 0.6 && speed < 1.5) return true;
    }
    return false;
  };
  EXPECT_TRUE(Eventually(somebody_walks, kPatience)) << Diagnosis();
  EXPECT_TRUE(Eventually([&] { return markers.get() && !markers.get()->markers.empty(); }, 5));
  EXPECT_TRUE(Eventually([&] { return Diagnosis() == "looking for people"; }, 5)) << Diagnosis();
}

TEST_F(PeopleNodeTest, WithoutCloudsWhoWalksByIsFollowedByTheLegs) {
  StartSimulator();
  StartPeople({"_frame:=map", "/velodyne_points:=/nothing"});
  const auto legs_are_followed = [&] {
    const auto people = people_.get();
    if (!people) return false;
    for (const auto& person : people->people) {
      const double speed = std::hypot(person.velocity.x, person.velocity.y);
      if (person.seen_by == coppice_msgs::Person::LASER && person.known_for > 1 && speed > 0.6) {
        return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(Eventually(legs_are_followed, kPatience)) << Diagnosis();
}

TEST_F(PeopleNodeTest, WarnsThatPicturesComeTooLateToCount) {
  ros::Publisher sightings = node_.advertise<coppice_msgs::Sightings>("/people/sightings", 1);
  StartSimulator();
  StartPeople({"_frame:=map"});
  const auto says = [&](const std::string& what, double late) {
    coppice_msgs::Sightings seen;
    if (people_.get()) seen.header.stamp = people_.get()->header.stamp - ros::Duration(late);
    seen.header.frame_id = "map";
    seen.camera = "front";
    sightings.publish(seen);
    return Diagnosis().find(what) != std::string::npos;
  };
  EXPECT_TRUE(Eventually([&] { return people_.get() && says("looking", 0); }, kPatience))
      << Diagnosis();
  EXPECT_TRUE(Eventually([&] { return says("what the camera front sees comes", 2.2); }, kPatience))
      << Diagnosis();
  EXPECT_EQ(diagnostics_.get()->status[0].level, diagnostic_msgs::DiagnosticStatus::WARN);
  // Of a camera that has ended nothing is late.
  EXPECT_TRUE(Eventually([&] { return Diagnosis() == "looking for people"; }, kPatience))
      << Diagnosis();
}

TEST_F(PeopleNodeTest, SaysThatThereAreNoClouds) {
  StartPeople();
  EXPECT_TRUE(Eventually([&] { return Diagnosis() == "no clouds on /velodyne_points"; }, kPatience))
      << Diagnosis();
}

TEST_F(PeopleNodeTest, SaysWhatIsWrongWithACloudAndLivesOn) {
  ros::param::set("/use_sim_time", false);  // there is no simulator
  ros::Publisher clouds = node_.advertise<sensor_msgs::PointCloud2>("/velodyne_points", 1);
  StartPeople();
  sensor_msgs::PointCloud2 broken;
  broken.header.stamp = ros::Time::now();
  broken.width = 1000000;
  broken.height = 1000000;
  broken.point_step = 22;
  const auto says = [&] {
    clouds.publish(broken);
    return Diagnosis().find("1000000 x 1000000") != std::string::npos;
  };
  EXPECT_TRUE(Eventually(says, kPatience)) << Diagnosis();
  EXPECT_TRUE(people_program_.IsRunning());
}

TEST_F(PeopleNodeTest, ACloudFromTheEndOfTimeDoesNotEndIt) {
  ros::param::set("/use_sim_time", false);  // there is no simulator
  ros::Publisher clouds = node_.advertise<sensor_msgs::PointCloud2>("/velodyne_points", 1);
  StartPeople();
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = ros::Time(0xFFFFFFFF, 999999999);
  const auto says = [&] {
    clouds.publish(cloud);
    return Diagnosis().find("ahead of now") != std::string::npos;
  };
  EXPECT_TRUE(Eventually(says, kPatience)) << Diagnosis();
  EXPECT_TRUE(people_program_.IsRunning());
}

TEST_F(PeopleNodeTest, AWrongClassifierEndsItAtTheStartWithTheReason) {
  StartPeople({"_classifier:=/nowhere.yaml"});
  ASSERT_TRUE(Eventually([&] { return !people_program_.IsRunning(); }, kPatience));
  EXPECT_EQ(people_program_.exit_status(), 1);
  EXPECT_THAT(TextOf(Temporary("people.log")), HasSubstr("/nowhere.yaml: cannot be read"));
}

}  // namespace
}  // namespace coppice::robot::perception
