#include "robot_app/slam/map/navigation_frame.h"

#include <algorithm>
#include <cmath>

#include "robot_app/slam/graph/floor_pose.h"
#include "robot_app/slam/graph/planar_fit.h"

namespace coppice::robot::slam {
namespace {

constexpr std::size_t kDraws = 40;   // key frames that may say it for all
constexpr double kAgree = 1;         // m: the map bends a little, and a heading is off a little
constexpr double kAgreeTurn = 0.15;  // rad
constexpr double kSpread = 1;        // m: nearer together they do not tell the heading
constexpr int kFits = 3;

// Of one key frame.
struct Pair {
  Pose3 mapped;  // in the frame of its map
  Pose3 place;   // in that of the navigation's
};

std::vector<Pair> Agreeing(const std::vector<Pair>& pairs, const Pose3& frame) {
  std::vector<Pair> agreeing;
  for (const Pair& pair : pairs) {
    const Pose3 off = pair.place.inverse() * frame * pair.mapped;
    if (off.translation().norm() <= kAgree &&
        Eigen::AngleAxisd(off.linear()).angle() <= kAgreeTurn) {
      agreeing.push_back(pair);
    }
  }
  return agreeing;
}

// Least squares, where the key frames lie far enough apart.
Pose3 Fit(const std::vector<Pair>& pairs, const Pose3& otherwise) {
  std::vector<Eigen::Vector3d> places, mapped;
  double farthest = 0;
  for (const Pair& pair : pairs) {
    places.push_back(pair.place.translation());
    mapped.push_back(pair.mapped.translation());
    farthest = std::max(farthest, (mapped.back() - mapped.front()).norm());
  }
  return farthest >= kSpread ? PlanarFit(places, mapped) : otherwise;
}

std::optional<Pose3> FrameOf(const std::vector<Pair>& pairs) {
  std::optional<Pose3> best;
  std::size_t most = 0;
  const std::size_t stride = 1 + pairs.size() / kDraws;
  for (std::size_t i = 0; i < pairs.size(); i += stride) {
    const Pose3 frame = pairs[i].place * pairs[i].mapped.inverse();
    const std::size_t agree = Agreeing(pairs, frame).size();
    if (agree > most) {
      best = frame;
      most = agree;
    }
  }
  for (int i = 0; best && i < kFits; ++i) best = Fit(Agreeing(pairs, *best), *best);
  return best;
}

}  // namespace

std::vector<std::optional<Pose3>> OnNavigationMap(
    const SessionGraph& graph, const std::vector<std::shared_ptr<const KeyFrame>>& key_frames) {
  std::vector<std::vector<Pair>> pairs(graph.session_count());  // of the map of this session
  for (std::size_t i = 0; i < key_frames.size(); ++i) {
    if (key_frames[i] == nullptr || !key_frames[i]->place) continue;
    pairs[graph.map_of(graph.sessions()[i])].push_back(
        {graph.poses()[i], ToPose3(*key_frames[i]->place)});
  }
  std::vector<std::optional<Pose3>> frames(pairs.size());
  for (std::uint32_t i = 0; i < frames.size(); ++i) {
    // A map bears the number of its oldest session.
    frames[i] = graph.map_of(i) == i ? FrameOf(pairs[i]) : frames[graph.map_of(i)];
  }
  return frames;
}

SlamMap MovedToNavigationMap(SlamMap map) {
  const auto frames = OnNavigationMap({{}, map.graph, map.sessions}, map.key_frames);
  for (std::size_t i = 0; i < map.sessions.size(); ++i) {
    const auto& frame = frames[map.sessions[i]];
    if (frame) map.graph.poses[i] = *frame * map.graph.poses[i];
  }
  return map;
}

}  // namespace coppice::robot::slam
