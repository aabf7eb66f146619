#include "robot_app/deployment/world/floor_ways.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot_app/simulation/grid_map.h"

namespace coppice::robot::deployment {
namespace {

using simulation::Vec2;

constexpr double kDoorThickness = 0.1;  // m

OccupancyGrid MapOf(const simulation::Floor& floor, double resolution) {
  simulation::GridMap map = simulation::MakeGridMap(floor, resolution);
  return {{map.resolution, map.origin.x, map.origin.y, map.width, map.height},
          std::move(map.cells)};
}

simulation::Rectangle LeafOf(const simulation::Door& door) {
  const Vec2 along = door.end - door.hinge;
  return {(door.hinge + door.end) * 0.5,
          {simulation::Length(along), kDoorThickness},
          std::atan2(along.y, along.x)};
}

}  // namespace

FloorWays::FloorWays(simulation::Floor floor, double resolution)
    : floor_(std::move(floor)), map_(MapOf(floor_, resolution)) {
  for (const simulation::Door& door : floor_.doors) {
    closables_.push_back({door.name, true, LeafOf(door)});
  }
  for (const simulation::FloorBox& place : floor_.places) {
    closables_.push_back({place.name, false, place.shape});
  }
  Update();
  home_.emplace(costmap_, Point2D{floor_.staging.x, floor_.staging.y});
}

const FloorWays::Way& FloorWays::Find(const Pose2D& from, const Pose2D& to) {
  const GridFrame& frame = map_.frame;
  const std::vector<int> ends = {frame.Index(frame.CellAt(from.x, from.y)),
                                 frame.Index(frame.CellAt(to.x, to.y))};
  const auto known = found_.find(ends);
  if (known != found_.end()) return known->second;
  const navigation::Plan plan = navigation::FindPath(costmap_, {from.x, from.y}, {to.x, to.y}, 0.5);
  Way way;
  if (plan.status == navigation::PlanStatus::kOk) {
    way = navigation::SmoothPath(costmap_, plan.points, 0.25);
  }
  return found_[ends] = std::move(way);
}

std::optional<double> FloorWays::LengthHome(const Pose2D& from) const {
  return home_->Length({from.x, from.y});
}

std::string FloorWays::PassedBy(const Way& way, double ahead, bool doors) const {
  double along = 0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    along += Distance(way[i - 1], way[i]);
    if (along < ahead) continue;
    for (const Closable& closable : closables_) {
      if (closable.is_door != doors) continue;
      if (simulation::Distance({way[i].x, way[i].y}, closable.shape) < 0.2) return closable.name;
    }
  }
  return {};
}

void FloorWays::Close(const std::string& name) {
  closed_.push_back(name);
  Update();
}

void FloorWays::Open(const std::string& name) {
  closed_.erase(std::remove(closed_.begin(), closed_.end(), name), closed_.end());
  Update();
}

std::vector<int> FloorWays::CellsOf(const Closable& closable) const {
  std::vector<int> cells;
  for (int index = 0; index < map_.frame.size(); ++index) {
    const Point2D middle = map_.frame.Center(map_.frame.CellOf(index));
    if (simulation::Distance({middle.x, middle.y}, closable.shape) < map_.frame.resolution) {
      cells.push_back(index);
    }
  }
  return cells;
}

void FloorWays::Update() {
  std::vector<int> obstacles;
  for (const Closable& closable : closables_) {
    if (std::find(closed_.begin(), closed_.end(), closable.name) == closed_.end()) continue;
    const std::vector<int> cells = CellsOf(closable);
    obstacles.insert(obstacles.end(), cells.begin(), cells.end());
  }
  costmap_.Update(map_, obstacles);
  found_.clear();
}

}  // namespace coppice::robot::deployment
