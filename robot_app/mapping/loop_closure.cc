#include "robot_app/mapping/loop_closure.h"

#include <algorithm>
#include <cmath>

#include "robot_app/localization/place_search.h"
#include "robot_app/localization/scan_matcher.h"

namespace coppice::robot::mapping {
namespace {

using localization::Beam;

constexpr double kNear = 1.5;        // so much farther than the doubt an old frame may lie [m]
constexpr std::size_t kBeside = 12;  // key frames before and after it that saw the same
constexpr std::size_t kLately = 8;   // key frames that are laid upon them
constexpr double kSpacing = 0.1;     // of the beams [m]
constexpr int kBeamsOfOne = 150;
constexpr std::size_t kPlaces = 4;
constexpr double kClearlyBest = 0.1;  // another place must fit so much worse

// The one that lies nearest to the newest frame, of those that do not belong to the same stretch of
// the way.
std::optional<std::size_t> NearestOld(const KeyFrames& frames, double within,
                                      const MappingSettings& settings) {
  std::optional<std::size_t> nearest;
  const std::size_t old = frames.size() - std::min(frames.size(), settings.window);
  for (std::size_t i = 0; i < old; ++i) {
    const double distance = Distance(frames.poses[i], frames.poses.back());
    if (distance > within) continue;
    within = distance;
    nearest = i;
  }
  return nearest;
}

// What was seen lately, from the newest frame.
std::vector<Beam> SeenLately(const KeyFrames& frames, double range) {
  std::vector<Beam> seen;
  const std::size_t newest = frames.size() - 1;
  for (std::size_t i = frames.size() - std::min(frames.size(), kLately); i <= newest; ++i) {
    const std::vector<Beam> beams = BeamsWithin(frames.scans[i], range, kSpacing, kBeamsOfOne);
    const std::vector<Beam> moved =
        localization::Moved(beams, RelativeTo(frames.poses[newest], frames.poses[i]));
    seen.insert(seen.end(), moved.begin(), moved.end());
  }
  return seen;
}

// Only around `middle` may the robot be.
void KeepFreeAround(const Pose2D& middle, double radius, OccupancyGrid& map) {
  for (int i = 0; i < map.frame.size(); ++i) {
    if (map.cells[i] >= OccupancyGrid::kOccupied) continue;
    const Point2D center = map.frame.Center(map.frame.CellOf(i));
    const double x = center.x - middle.x;
    const double y = center.y - middle.y;
    map.cells[i] = x * x + y * y <= radius * radius ? std::int8_t{0} : std::int8_t{-1};
  }
}

}  // namespace

std::optional<PoseConstraint> FindLoopClosure(const KeyFrames& frames, const PoseDoubt& doubt,
                                              const MappingSettings& settings) {
  const auto old = NearestOld(frames, doubt.position + kNear, settings);
  if (!old) return std::nullopt;
  const std::size_t first = *old - std::min(*old, kBeside);
  const std::size_t end = std::min(*old + kBeside + 1, frames.size() - settings.window);
  const Pose2D& here = frames.poses.back();
  OccupancyGrid map = MapOf(frames, first, end, settings);
  KeepFreeAround(here, doubt.position, map);
  const localization::LikelihoodField field(map);
  const std::vector<Beam> seen = SeenLately(frames, settings.range);
  std::vector<localization::FittingPlace> places =
      localization::PlaceSearch(field).Find(seen, kPlaces);
  places.erase(std::remove_if(places.begin(), places.end(),
                              [&](const localization::FittingPlace& place) {
                                return std::abs(NormalizeAngle(place.pose.yaw - here.yaw)) >
                                       doubt.yaw;
                              }),
               places.end());
  if (places.empty() || places[0].agreement.share() < settings.loop_agree) return std::nullopt;
  const Pose2D& found = places[0].pose;
  if (places.size() > 1 &&
      places[1].agreement.share() > places[0].agreement.share() - kClearlyBest) {
    return std::nullopt;
  }
  PoseConstraint closure;
  closure.from = *old;
  closure.to = frames.size() - 1;
  closure.relative = RelativeTo(frames.poses[*old], found);
  closure.information = AlongAxesOf(found, localization::MatchInformation(field, seen, found));
  closure.doubtful = true;
  return closure;
}

}  // namespace coppice::robot::mapping
