#include "robot_app/perception/people/sighting_messages.h"

#include <Eigen/Dense>
#include <cmath>
#include <string>

namespace coppice::robot::perception {
namespace {

constexpr double kFarthest = 1e6;        // no robot is there [m]
constexpr double kLeastVariance = 1e-6;  // m^2
constexpr double kMostVariance = 100;

bool IsPlace(const coppice_msgs::Sighting& message) {
  return std::abs(message.position.x) < kFarthest && std::abs(message.position.y) < kFarthest;
}

// Symmetric, and neither needle nor nothing: the tracker divides by it.
bool IsCovariance(const Eigen::Matrix2d& covariance) {
  return covariance(0, 1) == covariance(1, 0) && covariance.trace() < kMostVariance &&
         covariance(0, 0) > kLeastVariance && covariance(1, 1) > kLeastVariance &&
         covariance.determinant() > kLeastVariance * kLeastVariance;
}

PlacedSighting FromMessage(const coppice_msgs::Sighting& message) {
  PlacedSighting placed;
  placed.sighting = {static_cast<SightingKind>(message.kind),
                     {message.x, message.y, message.width, message.height},
                     message.confidence};
  placed.place.by = static_cast<RangedBy>(message.ranged_by);
  if (placed.place.by == RangedBy::kNothing) return placed;
  placed.place.position = {message.position.x, message.position.y};
  placed.place.covariance << message.covariance[0], message.covariance[1], message.covariance[2],
      message.covariance[3];
  return placed;
}

}  // namespace

coppice_msgs::Sighting ToMessage(const PlacedSighting& placed) {
  coppice_msgs::Sighting message;
  message.kind = static_cast<std::uint8_t>(placed.sighting.kind);
  message.confidence = static_cast<float>(placed.sighting.confidence);
  message.x = static_cast<float>(placed.sighting.box.x);
  message.y = static_cast<float>(placed.sighting.box.y);
  message.width = static_cast<float>(placed.sighting.box.width);
  message.height = static_cast<float>(placed.sighting.box.height);
  message.ranged_by = static_cast<std::uint8_t>(placed.place.by);
  if (placed.place.by == RangedBy::kNothing) return message;
  message.position.x = placed.place.position.x();
  message.position.y = placed.place.position.y();
  for (int i = 0; i < 4; ++i) message.covariance[i] = placed.place.covariance(i / 2, i % 2);
  // Rounding may have told two halves of the matrix apart.
  message.covariance[2] = message.covariance[1];
  return message;
}

Expected<std::vector<PlacedSighting>> FromMessage(const coppice_msgs::Sightings& message) {
  using coppice_msgs::Sighting;
  std::vector<PlacedSighting> sightings;
  for (std::size_t i = 0; i < message.sightings.size(); ++i) {
    const Sighting& one = message.sightings[i];
    const PlacedSighting placed = FromMessage(one);
    const bool is_placed = placed.place.by != RangedBy::kNothing;
    const char* wrong = one.kind > Sighting::FACE_WITHOUT_MASK                ? "kind"
                        : !(one.confidence >= 0 && one.confidence <= 1)       ? "confidence"
                        : one.ranged_by > Sighting::DEPTH                     ? "ranged_by"
                        : is_placed && !IsPlace(one)                          ? "position"
                        : is_placed && !IsCovariance(placed.place.covariance) ? "covariance"
                                                                              : nullptr;
    if (wrong != nullptr) {
      return Problem{"sighting " + std::to_string(i) + " of camera \"" + message.camera +
                     "\" has a wrong " + wrong};
    }
    sightings.push_back(placed);
  }
  return sightings;
}

}  // namespace coppice::robot::perception
