#include "robot_app/perception/sightings/joined_sightings.h"

#include <algorithm>
#include <optional>

namespace coppice::robot::perception {
namespace {

constexpr double kSameOne = 0.45;  // two people's axes are no nearer [m]

bool IsPerson(const PlacedSighting& placed) {
  return placed.sighting.kind == SightingKind::kPerson;
}

std::optional<bool> MaskOf(SightingKind kind) {
  if (kind == SightingKind::kFaceWithMask) return true;
  if (kind == SightingKind::kFaceWithoutMask) return false;
  return std::nullopt;
}

Detection DetectionOf(const PlacedSighting& placed) {
  return {placed.place.position, placed.place.covariance, placed.sighting.confidence,
          Modality::kCamera, MaskOf(placed.sighting.kind)};
}

Detection* NearestOf(std::vector<Detection>& detections, const Eigen::Vector2d& at) {
  Detection* nearest = nullptr;
  double distance = kSameOne;
  for (Detection& detection : detections) {
    const double away = (detection.position - at).norm();
    if (away < distance) {
      nearest = &detection;
      distance = away;
    }
  }
  return nearest;
}

}  // namespace

std::vector<Detection> Join(std::vector<PlacedSighting> sightings) {
  // Bodies before faces, each the surest first.
  std::stable_sort(sightings.begin(), sightings.end(),
                   [](const PlacedSighting& a, const PlacedSighting& b) {
                     if (IsPerson(a) != IsPerson(b)) return IsPerson(a);
                     return a.sighting.confidence > b.sighting.confidence;
                   });
  std::vector<Detection> detections;
  for (const PlacedSighting& placed : sightings) {
    if (placed.place.by == RangedBy::kNothing) continue;
    Detection* known = NearestOf(detections, placed.place.position);
    if (known == nullptr) {
      detections.push_back(DetectionOf(placed));
      continue;
    }
    known->probability = std::max(known->probability, placed.sighting.confidence);
    if (!known->has_mask) known->has_mask = MaskOf(placed.sighting.kind);
  }
  return detections;
}

}  // namespace coppice::robot::perception
