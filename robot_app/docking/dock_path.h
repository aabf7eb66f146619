// The way from where the robot stands into the station: a turn on the spot, a Dubins path
// (dubins.h), and the last stretch straight on, along the station's axis. All in the frame of the
// station: its origin is base_link when docked, the x axis points into the station. So a path moves
// with the station as the robot sees it better. Pure functions.
#ifndef COPPICE_ROBOT_APP_DOCKING_DOCK_PATH_H_
#define COPPICE_ROBOT_APP_DOCKING_DOCK_PATH_H_

#include <optional>
#include <vector>

#include "robot_app/docking/dock_types.h"
#include "robot_app/docking/dubins.h"

namespace coppice::robot::docking {

struct DockPath {
  Pose2D from;          ///< where the robot stands
  DubinsPath curve;     ///< from there, with the heading to which it turns first
  double straight = 0;  ///< after that, up to the contacts [m]

  double length() const { return curve.length() + straight; }
  /// After `way` metres; beyond its end it goes on straight.
  Pose2D At(double way) const;
  /// The way at which the path is nearest to `point`, not before `since` and not more than `ahead`
  /// after it.
  double Nearest(const Point2D& point, double since, double ahead) const;
};

/// The way that takes the least time of those on which nothing is in the way; nothing if there is
/// none. `aside`: of the axis on which it ends, to the left [m]. `obstacles`: points, without those
/// of the station itself (WithoutStation). What is too near already must only not come nearer.
std::optional<DockPath> PlanDockPath(const Pose2D& robot, double aside,
                                     const std::vector<Point2D>& obstacles,
                                     const DockSettings& settings);

/// What is kept from obstacles, beyond the robot's radius: by a way that is planned, and by one
/// that is driven, so that noise does not stop the robot beside a wall [m].
inline constexpr double kPlannedMargin = 0.04;
inline constexpr double kDrivenMargin = 0.015;

/// Is something nearer than `margin` to the way from `begin` to `end` metres of the path?
bool IsBlocked(const DockPath& path, double begin, double end,
               const std::vector<Point2D>& obstacles, const DockSettings& settings,
               double margin = kPlannedMargin);

/// What is not the landmark and not behind it, in the station's frame: `points` are in base_link.
std::vector<Point2D> WithoutStation(const std::vector<Point2D>& points, const Pose2D& robot,
                                    const LandmarkShape& shape);

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_DOCK_PATH_H_
