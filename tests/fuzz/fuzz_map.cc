#include <cstdlib>
#include <string>

#include "robot_app/slam/map/slam_map_file.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {

int FuzzMap(std::string_view bytes) {
  const auto map = robot::slam::ParseSlamMap(bytes);
  if (!map) return 0;
  const std::size_t frames = map->key_frames.size();
  if (map->sessions.size() != frames || map->graph.poses.size() != frames) std::abort();
  const std::size_t sessions = frames == 0 ? 0 : map->sessions.back() + 1;
  if (map->names.size() != sessions) std::abort();
  for (const auto& link : map->graph.links) {
    if (link.from >= frames || link.to >= frames) std::abort();
  }
  // What is read is written as it was, so a map does not wander from save to save.
  const auto again = robot::slam::ParseSlamMap(robot::slam::BytesOf(*map));
  if (!again || again->key_frames.size() != frames) std::abort();
  return 1;
}

}  // namespace coppice::fuzz
