#include "robot_app/localization/pose_history.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::localization {
namespace {

constexpr double kFastest = 3;      // m/s
constexpr double kFastestTurn = 6;  // rad/s
constexpr double kSlack = 0.1;      // m and rad
constexpr double kOvertaken = 1;    // an older message than that was not overtaken [s]

bool Reachable(const Pose2D& from, const Pose2D& to, double seconds) {
  return Distance(from, to) < kFastest * seconds + kSlack &&
         std::abs(NormalizeAngle(to.yaw - from.yaw)) < kFastestTurn * seconds + kSlack;
}

}  // namespace

void PoseHistory::Add(double stamp, const Pose2D& pose) {
  if (!std::isfinite(stamp + pose.x + pose.y + pose.yaw)) return;
  if (!poses_.empty()) {
    const double passed = stamp - newest();
    if (passed <= 0 && passed > -kOvertaken) return;
    if (passed < 0 || !Reachable(poses_.back().pose, pose, passed)) {
      poses_.clear();
      ++frame_;
    }
  }
  poses_.push_back({stamp, pose});
  while (poses_.front().stamp < stamp - seconds_) poses_.pop_front();
}

std::optional<Pose2D> PoseHistory::At(double stamp) const {
  if (poses_.empty() || stamp < poses_.front().stamp || !(stamp <= newest())) return std::nullopt;
  const auto after =
      std::lower_bound(poses_.begin(), poses_.end(), stamp,
                       [](const Stamped& element, double time) { return element.stamp < time; });
  if (after->stamp == stamp || after == poses_.begin()) return after->pose;
  const auto before = std::prev(after);
  const double part = (stamp - before->stamp) / (after->stamp - before->stamp);
  const double turn = NormalizeAngle(after->pose.yaw - before->pose.yaw);
  return Pose2D{before->pose.x + part * (after->pose.x - before->pose.x),
                before->pose.y + part * (after->pose.y - before->pose.y),
                NormalizeAngle(before->pose.yaw + part * turn)};
}

}  // namespace coppice::robot::localization
