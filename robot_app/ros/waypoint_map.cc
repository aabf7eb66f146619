#include "robot_app/ros/waypoint_map.h"

#include <random>
#include <stdexcept>
#include <utility>

#include "robot_app/navigation/topological_map.h"

namespace coppice::robot::adapters {
namespace {

using leaves::Waypoint;
using navigation::TopologicalMap;

class TopologicalWaypoints : public leaves::WaypointMap {
 public:
  TopologicalWaypoints(TopologicalMap map, unsigned seed) : map_(std::move(map)), random_(seed) {}

  Waypoint ChooseForPatrol() override {
    last_ = map_.ChooseNext(random_, last_);
    return At(last_);
  }

  bool Find(const std::string& name, Waypoint& waypoint) const override {
    const int index = map_.Find(name);
    if (index < 0) return false;
    waypoint = At(index);
    return true;
  }

 private:
  Waypoint At(int index) const {
    const navigation::Place& place = map_.places()[static_cast<std::size_t>(index)];
    return {place.name, place.pose};
  }

  const TopologicalMap map_;
  std::mt19937 random_;
  int last_ = -1;
};

}  // namespace

std::unique_ptr<leaves::WaypointMap> LoadWaypointMap(const std::string& path, unsigned seed) {
  Diagnostics diagnostics;
  std::optional<TopologicalMap> map = TopologicalMap::Load(path, diagnostics);
  if (!map) throw std::runtime_error("cannot use the waypoints:\n" + diagnostics.ToString());
  std::mt19937 probe(seed);
  if (map->ChooseNext(probe, -1) < 0) {
    throw std::runtime_error(path + ": no waypoint has the category \"patrol\"");
  }
  return std::make_unique<TopologicalWaypoints>(*std::move(map), seed);
}

}  // namespace coppice::robot::adapters
