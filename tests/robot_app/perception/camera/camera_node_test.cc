// coppice-camera with the simulator and its cameras over ROS.
#include <coppice_msgs/InjectFault.h>
#include <coppice_msgs/Sightings.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>

#include <mutex>

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

constexpr double kPatience = 60;  // wall time [s]
const std::string kPrograms = BinaryFolder() + "/bin/";

class CameraNodeTest : public testing::Test {
 protected:
  // In the entrance hall, where two people walk about.
  void StartSimulation() {
    ros::param::set("/use_sim_time", true);  // before anybody starts
    simulator_ =
        ChildProcess({kPrograms + "coppice-simulator", "_start:=44 0 0", "_localization:=true"},
                     Temporary("simulator.log"));
    cameras_ = ChildProcess({kPrograms + "coppice-simulated-cameras"}, Temporary("cameras.log"));
  }
  void StartCamera(const std::vector<std::string>& arguments) {
    std::vector<std::string> command{kPrograms + "coppice-camera"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    program_ = ChildProcess(command, Temporary("camera.log"));
  }
  std::string Diagnosis() const {
    const auto message = diagnostics_.get();
    return message && !message->status.empty() ? message->status[0].message : "";
  }

  ros::NodeHandle node_;
  Latest<coppice_msgs::Sightings> sightings_{node_, "/people/sightings"};
  Latest<diagnostic_msgs::DiagnosticArray> diagnostics_{node_, "/diagnostics"};
  ChildProcess simulator_, cameras_, program_;
};

TEST_F(CameraNodeTest, SeesWhoWalksByAndWhere) {
  StartSimulation();
  StartCamera({"_frame:=map"});
  const auto sees_somebody = [&] {
    const auto message = sightings_.get();
    if (!message) return false;
    for (const auto& sighting : message->sightings) {
      const bool is_in_hall = sighting.position.x > 39 && std::abs(sighting.position.y) < 7;
      if (sighting.ranged_by != 0 && is_in_hall) return true;
    }
    return false;
  };
  EXPECT_TRUE(Eventually(sees_somebody, kPatience)) << Diagnosis();
  EXPECT_TRUE(Eventually([&] { return Diagnosis() == "looking for people"; }, 10)) << Diagnosis();
}

TEST_F(CameraNodeTest, TellsOfACameraWhoseDataIsDamaged) {
  StartSimulation();
  StartCamera({"_frame:=map", "_cameras:=front", "_period:=0.1"});
  ASSERT_TRUE(Eventually([&] { return sightings_.get() != nullptr; }, kPatience)) << Diagnosis();
  coppice_msgs::InjectFault worn;
  worn.request.fault = "wear_camera";
  worn.request.target = "front";
  worn.request.value = 180 / kSlowness;  // all of it within twenty seconds, when it looks so often
  ASSERT_TRUE(ros::service::call("/simulation/inject_fault", worn));
  const auto says = [&] { return Diagnosis().find("is the cable damaged?") != std::string::npos; };
  EXPECT_TRUE(Eventually(says, kPatience)) << Diagnosis();
}

TEST_F(CameraNodeTest, WithoutTheLidarItLooksAtTheDepthBetweenTwoPictures) {
  std::mutex mutex;  // the messages come on another thread
  std::vector<ros::Time> moments;
  const boost::function<void(const coppice_msgs::Sightings::ConstPtr&)> add =
      [&](const coppice_msgs::Sightings::ConstPtr& seen) {
        const std::lock_guard<std::mutex> lock(mutex);
        moments.push_back(seen->header.stamp);
      };
  const ros::Subscriber subscriber =
      node_.subscribe<coppice_msgs::Sightings>("/people/sightings", 10, add);
  StartSimulation();
  StartCamera({"_frame:=map", "_cameras:=front", "_lidar:=false", "_period:=10"});
  const auto looks_often = [&] {
    const std::lock_guard<std::mutex> lock(mutex);
    for (std::size_t i = 1; i < moments.size(); ++i) {
      const double between = (moments[i] - moments[i - 1]).toSec();
      if (between > 0 && between < 4) return true;
    }
    return false;
  };
  EXPECT_TRUE(Eventually(looks_often, kPatience)) << Diagnosis();
}

TEST_F(CameraNodeTest, SaysWhatIsWrongWithAPictureAndLivesOn) {
  const std::string topics = "/camera/front/";
  auto colour =
      node_.advertise<sensor_msgs::CompressedImage>(topics + "color/image_raw/compressed", 1);
  auto depth = node_.advertise<sensor_msgs::CompressedImage>(
      topics + "aligned_depth_to_color/image_raw/compressedDepth", 1);
  auto info = node_.advertise<sensor_msgs::CameraInfo>(topics + "color/camera_info", 1);
  StartCamera({"_cameras:=front"});
  sensor_msgs::CompressedImage picture;
  picture.header.frame_id = "camera_front_optical";
  picture.data = {1, 2, 3};
  sensor_msgs::CameraInfo lens;
  lens.header = picture.header;
  lens.K = {600, 0, 320, 0, 600, 240, 0, 0, 1};
  const auto says = [&] {
    picture.header.stamp = lens.header.stamp = ros::Time::now();
    info.publish(lens);
    depth.publish(picture);
    colour.publish(picture);
    return Diagnosis().find("JPEG") != std::string::npos;
  };
  EXPECT_TRUE(Eventually(says, kPatience)) << Diagnosis();
  EXPECT_TRUE(program_.IsRunning());
}

TEST_F(CameraNodeTest, AWrongMaskClassifierEndsItAtTheStartWithTheReason) {
  StartCamera({"_mask_classifier:=/nowhere.yaml"});
  ASSERT_TRUE(Eventually([&] { return !program_.IsRunning(); }, kPatience));
  EXPECT_EQ(program_.exit_status(), 1);
  EXPECT_THAT(TextOf(Temporary("camera.log")), HasSubstr("/nowhere.yaml: cannot be read"));
}

}  // namespace
}  // namespace coppice::robot::perception
