#include "robot_app/perception/legs/leg_finder.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::perception {
namespace {

constexpr std::uint32_t kLeastPoints = 2;
constexpr float kWidest = 0.6F;          // of both legs side by side [m]
constexpr float kWidestOfPair = 0.4F;    // of one of two [m]
constexpr float kLongestStep = 0.6F;     // between the middles of two legs [m]
constexpr std::size_t kMostBetween = 8;  // small segments from one leg to the other
constexpr float kApart = 0.5F;           // two people's axes are no nearer [m]
constexpr float kSure = 0.9F;            // surer makes no difference
constexpr float kHalfLeg = 0.06F;  // the axis lies so far behind the middle of what is seen [m]
constexpr float kOneLeg = 0.25F;   // what is narrower is one leg [m]
constexpr double kBefore = 0.4;    // what stands so much nearer hides [m]

bool Share(const LegCandidate& a, const LegCandidate& b) {
  const auto has = [&b](std::uint32_t segment) {
    return segment == b.first || (b.second && segment == *b.second);
  };
  return has(a.first) || (a.second && has(*a.second));
}

std::uint32_t PointsOf(const SegmentedScan& scan, const LegCandidate& candidate) {
  return scan.segments[candidate.first].size() +
         (candidate.second ? scan.segments[*candidate.second].size() : 0);
}

// Half a leg farther than the middle of what is seen of it.
Eigen::Vector2f AxisOf(const SegmentedScan& scan, std::uint32_t segment) {
  const Eigen::Vector2f middle = MiddleOf(scan, scan.segments[segment]);
  return middle * (1 + kHalfLeg / std::max(middle.norm(), 0.01F));
}

// Where the other leg is when one is seen, nobody knows. Legs swing: even of both the middle is
// seldom below the body's axis.
SeenLegs Locate(const SegmentedScan& scan, const LegCandidate& candidate) {
  SeenLegs person;
  person.legs = candidate;
  const ScanSegment& first = scan.segments[candidate.first];
  person.position = AxisOf(scan, candidate.first);
  person.beam = scan.points[(first.begin + first.end) / 2].beam;
  float deviation = WidthOf(scan, first) < kOneLeg ? 0.2F : 0.12F;
  if (candidate.second) {
    person.position = (person.position + AxisOf(scan, *candidate.second)) / 2;
    deviation = 0.08F;
  }
  person.covariance *= deviation * deviation;
  return person;
}

}  // namespace

std::vector<LegCandidate> LegCandidatesIn(const SegmentedScan& scan) {
  std::vector<LegCandidate> candidates;
  std::vector<std::uint32_t> legs;
  for (std::uint32_t i = 0; i < scan.segments.size(); ++i) {
    const ScanSegment& segment = scan.segments[i];
    const float width = WidthOf(scan, segment);
    if (segment.size() < kLeastPoints || width > kWidest) continue;
    candidates.push_back({i, std::nullopt});
    if (width <= kWidestOfPair) legs.push_back(i);
  }
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Eigen::Vector2f at = MiddleOf(scan, scan.segments[legs[i]]);
    const std::size_t end = std::min(legs.size(), i + 1 + kMostBetween);
    for (std::size_t j = i + 1; j < end; ++j) {
      const float step = (MiddleOf(scan, scan.segments[legs[j]]) - at).norm();
      if (step <= kLongestStep) candidates.push_back({legs[i], legs[j]});
    }
  }
  return candidates;
}

const std::vector<SeenLegs>& LegFinder::Find(const LaserScan& scan) {
  SegmentByJumps(scan, options_.farthest, segmented_);
  sure_.clear();
  for (const LegCandidate& candidate : LegCandidatesIn(segmented_)) {
    const float probability = classifier_.Probability(Describe(segmented_, candidate));
    if (probability < options_.least_probability) continue;
    sure_.push_back(Locate(segmented_, candidate));
    sure_.back().probability = probability;
  }
  // Of those that are sure enough both legs go before one.
  const auto rank = [&](const SeenLegs& person) {
    return std::make_pair(std::min(person.probability, kSure), PointsOf(segmented_, person.legs));
  };
  std::stable_sort(sure_.begin(), sure_.end(),
                   [&](const SeenLegs& a, const SeenLegs& b) { return rank(a) > rank(b); });
  people_.clear();
  for (const SeenLegs& person : sure_) {
    const bool is_known = std::any_of(people_.begin(), people_.end(), [&](const SeenLegs& other) {
      return Share(person.legs, other.legs) || (other.position - person.position).norm() < kApart;
    });
    if (!is_known) people_.push_back(person);
  }
  return people_;
}

bool IsHidden(const LaserScan& scan, float farthest, const Eigen::Vector2d& at) {
  const double distance = at.norm();
  const double beam =
      std::round((std::atan2(at.y(), at.x()) - scan.angle_min) / scan.angle_increment);
  if (distance > farthest || !(beam >= 0 && beam < static_cast<double>(scan.ranges.size()))) {
    return true;
  }
  const auto i = static_cast<std::size_t>(beam);
  return !scan.MetNothing(i) && (!scan.Hit(i) || scan.ranges[i] < distance - kBefore);
}

}  // namespace coppice::robot::perception
