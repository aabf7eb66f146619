// How a person drives who makes a map: along points, turning on the spot at corners.
#ifndef COPPICE_TESTS_ROBOT_APP_MAPPING_TOUR_H_
#define COPPICE_TESTS_ROBOT_APP_MAPPING_TOUR_H_

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "robot_app/common/pose2d.h"

namespace coppice::robot::mapping {

class Tour {
 public:
  explicit Tour(std::vector<Point2D> way) : way_(std::move(way)) {}

  /// What to do at `pose`; nothing at the end of the way.
  std::optional<Velocity2D> Next(const Pose2D& pose) {
    while (next_ < way_.size() && Distance(way_[next_], Point2D{pose.x, pose.y}) < kThere) ++next_;
    if (next_ == way_.size()) return std::nullopt;
    const double heading = std::atan2(way_[next_].y - pose.y, way_[next_].x - pose.x);
    const double off = NormalizeAngle(heading - pose.yaw);
    if (std::abs(off) > kCorner) return Velocity2D{0, off > 0 ? kTurn : -kTurn};
    return Velocity2D{kSpeed, std::clamp(2 * off, -kTurn, kTurn)};
  }

  double Length() const {
    double length = 0;
    for (std::size_t i = 1; i < way_.size(); ++i) length += Distance(way_[i - 1], way_[i]);
    return length;
  }

 private:
  static constexpr double kSpeed = 0.4;   // m/s, what the page allows
  static constexpr double kTurn = 0.8;    // rad/s
  static constexpr double kThere = 0.25;  // m
  static constexpr double kCorner = 0.4;  // rad

  std::vector<Point2D> way_;
  std::size_t next_ = 0;
};

/// Once through the institute: from before the station along the corridor into the open offices,
/// round both columns of the hall, and back.
inline std::vector<Point2D> RoundOfTheInstitute() {
  return {{8, 0},    {8.2, 3.4}, {8, 0},     {16, 0},  {16, -3.4},   {16, 0},     {24, 0},
          {24, 2.6}, {24, 0},    {24, -3.4}, {24, 0},  {32, 0},      {32.2, 3.4}, {32, 0},
          {42.5, 0}, {42.5, 4},  {46, 4},    {46, -4}, {42.5, -3.5}, {42.5, 0},   {0, 0}};
}

}  // namespace coppice::robot::mapping

#endif  // COPPICE_TESTS_ROBOT_APP_MAPPING_TOUR_H_
