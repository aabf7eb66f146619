#include "robot_app/slam/map/voxel_drawing.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace coppice::robot::slam {
namespace {

constexpr int kAtOnce = 5;           // key frames
constexpr double kWellEnough = 0.1;  // a pose may be off in the voxels [m]

bool HasMoved(const Pose3& drawn, const Pose3& now) {
  return (drawn.translation() - now.translation()).norm() > kWellEnough;
}

}  // namespace

void VoxelDrawing::DrawSome(const SessionGraph& graph, const Pose3& frame,
                            const KeyFrames& key_frame) {
  if (graph.poses().empty() || !worker_.IsIdle()) return;
  std::vector<Pose3> poses = graph.poses();
  for (Pose3& pose : poses) pose = frame * pose;
  const std::uint32_t map = graph.map_of(graph.sessions().back());
  if (map != map_ ||
      !std::equal(drawn_.begin(), drawn_.end(), poses.begin(), std::not_fn(HasMoved))) {
    drawn_.clear();
    shown_ = 0;
    map_ = map;
    worker_.Clear();
  }
  for (int i = 0; i < kAtOnce && drawn_.size() < poses.size(); ++i) {
    const auto next = static_cast<std::uint32_t>(drawn_.size());
    drawn_.push_back(poses[next]);
    if (graph.map_of(graph.sessions()[next]) != map) continue;
    const auto seen = key_frame(next);
    if (seen) worker_.Add(*seen, poses[next]);
  }
}

bool VoxelDrawing::Show(std::size_t key_frames, std::function<void(const OccupancyGrid&)> done) {
  if (drawn_.size() < key_frames || drawn_.size() == shown_) return false;
  shown_ = drawn_.size();
  worker_.Project(std::move(done));
  return true;
}

}  // namespace coppice::robot::slam
