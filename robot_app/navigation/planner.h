// The cheapest way on a costmap.
//
// A* on the 8-connected grid (P. E. Hart, N. J. Nilsson, B. Raphael: A Formal Basis for the
// Heuristic Determination of Minimum Cost Paths, 1968). A step costs its length times the mean
// cost of its two cells; diagonal steps do not cut the corner of a lethal cell. Unknown cells are
// lethal. Deterministic.
#ifndef COPPICE_ROBOT_APP_NAVIGATION_PLANNER_H_
#define COPPICE_ROBOT_APP_NAVIGATION_PLANNER_H_

#include <string>
#include <vector>

#include "robot_app/navigation/costmap.h"

namespace coppice::robot::navigation {

enum class PlanStatus : std::uint8_t {
  kOk,
  kStartBlocked,  ///< the robot stands in an obstacle, and no free cell is near
  kGoalBlocked,   ///< an obstacle is too near to the goal
  kNoPath,        ///< both are free, but nothing joins them
};

struct Plan {
  PlanStatus status = PlanStatus::kNoPath;
  std::vector<Point2D> points;  ///< from the start to the goal; empty unless kOk
  double cost = 0;              ///< of the way on the grid, between cell middles
  std::string message;          ///< what is wrong, for people; empty if kOk
};

/// Plans from `start` to `goal` [m]. A start in lethal cells (the robot has come too near to
/// something) is left by the nearest free cell within `leave_radius` [m].
Plan FindPath(const Costmap& costmap, Point2D start, Point2D goal, double leave_radius = 0.3);

/// The same way with fewer corners: a stretch is replaced by a straight line where that is free
/// and not dearer (string pulling on costs), up to a thousand cells; then points are set every
/// `spacing` metres.
std::vector<Point2D> SmoothPath(const Costmap& costmap, const std::vector<Point2D>& path,
                                double spacing = 0.05);

/// True if no cell that the polyline touches is lethal, apart from the first `skip` metres.
bool PathIsFree(const Costmap& costmap, const std::vector<Point2D>& path, double skip = 0);

/// Length of a polyline [m].
double PathLength(const std::vector<Point2D>& path);

}  // namespace coppice::robot::navigation

#endif  // COPPICE_ROBOT_APP_NAVIGATION_PLANNER_H_
