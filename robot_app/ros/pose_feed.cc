#include "robot_app/ros/pose_feed.h"

#include <std_msgs/Float64.h>

#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace coppice::robot::adapters {
namespace {

constexpr double kPeriod = 0.5;  // s, wall

Time WallNow() { return Time(std::chrono::steady_clock::now().time_since_epoch()); }

}  // namespace

PoseFeed::PoseFeed(ros::NodeHandle& node, const leaves::Pose2D& station,
                   std::vector<PoseKeys> trees)
    : station_(station),
      measured_(node.subscribe<std_msgs::Float64>(
          "/navigation/way_to_station", 1,
          boost::function<void(const std_msgs::Float64::ConstPtr&)>(
              [this](const std_msgs::Float64::ConstPtr& way) {
                const std::lock_guard<std::mutex> lock(mutex_);
                way_.OnMeasured(way->data, WallNow());
              }))),
      trees_(std::move(trees)),
      timer_(node.createWallTimer(ros::WallDuration(kPeriod), [this](const auto&) { Send(); })) {}

double PoseFeed::WayFrom(const leaves::Pose2D& pose) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return way_.Length(std::hypot(pose.x - station_.x, pose.y - station_.y), WallNow());
}

void PoseFeed::Send() {
  const std::optional<RobotPose::Stamped> newest = pose_.Newest();
  if (!newest) return;
  const leaves::Pose2D pose{newest->pose.x, newest->pose.y, newest->pose.yaw};
  const double way = WayFrom(pose);
  for (const PoseKeys& keys : trees_) {
    keys.pose.Send(pose);
    keys.distance_to_station.Send(way);
  }
}

}  // namespace coppice::robot::adapters
