#include "robot_app/ros/pose_feed.h"

#include <cmath>
#include <optional>
#include <utility>

namespace coppice::robot {
namespace {

constexpr double kDetour = 1.5;
constexpr double kPeriod = 0.5;  // s, wall

}  // namespace

double EstimatedWay(const coppice::Pose2D& from, const coppice::Pose2D& to) {
  return kDetour * std::hypot(to.x - from.x, to.y - from.y);
}

PoseFeed::PoseFeed(ros::NodeHandle& node, const coppice::Pose2D& station,
                   std::vector<PoseKeys> trees)
    : station_(station),
      trees_(std::move(trees)),
      timer_(node.createWallTimer(ros::WallDuration(kPeriod), [this](const auto&) { Send(); })) {}

void PoseFeed::Send() {
  const std::optional<RobotPose::Stamped> newest = pose_.Newest();
  if (!newest) return;
  const coppice::Pose2D pose{newest->pose.x, newest->pose.y, newest->pose.yaw};
  for (const PoseKeys& keys : trees_) {
    keys.pose.Send(pose);
    keys.distance_to_station.Send(EstimatedWay(pose, station_));
  }
}

}  // namespace coppice::robot
