// Drives the robot by hand for a test: by /cmd_vel/supervisor, as the page does.
#ifndef COPPICE_TESTS_SYSTEM_DRIVER_H_
#define COPPICE_TESTS_SYSTEM_DRIVER_H_

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <vector>

#include "robot_app/common/ros_support.h"
#include "tests/robot_app/mapping/tour.h"

namespace coppice::robot {

/// Sees where the robot is, as a person would.
class Driver {
 public:
  Driver() : command_(node_.advertise<geometry_msgs::Twist>("/cmd_vel/supervisor", 1)) {
    truth_ = node_.subscribe<geometry_msgs::PoseStamped>(
        "/simulation/truth", 1, [this](const geometry_msgs::PoseStamped::ConstPtr& message) {
          const std::lock_guard<std::mutex> lock(mutex_);
          pose_ = ToPose2D(message->pose);
          moved_.notify_one();
        });
  }
  ~Driver() { truth_.shutdown(); }

  /// From point to point of the map; one command for each time that the robot is seen. False: not
  /// within `patience` [s] of real time.
  bool Drive(const std::vector<Point2D>& way, double patience) {
    mapping::Tour tour(way);
    const auto deadline =
        std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
    std::optional<Velocity2D> command;
    do {
      std::unique_lock<std::mutex> lock(mutex_);
      if (!moved_.wait_until(lock, deadline, [this] { return pose_.has_value(); })) return false;
      command = tour.Next(*pose_);
      pose_.reset();
      command_.publish(ToTwist(command.value_or(Velocity2D{})));
    } while (command);
    return true;
  }

 private:
  ros::NodeHandle node_;
  ros::Publisher command_;
  ros::Subscriber truth_;
  std::mutex mutex_;
  std::condition_variable moved_;
  std::optional<Pose2D> pose_;  // since the last command
};

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_SYSTEM_DRIVER_H_
