#include "robot_app/perception/camera/people_in_pictures.h"

#include <algorithm>
#include <cmath>

#include "robot_app/perception/sightings/depth_turn.h"

namespace coppice::robot::perception {
namespace {

constexpr double kWidth = 0.5;        // of the box around a person who was found in depth [m]
constexpr double kLeastDetail = 8;    // standard deviation of the brightness, of 255
constexpr double kLeastDepth = 0.05;  // share of the pixels that have a distance
constexpr int kStep = 16;             // looked at is every so-manieth pixel

FinderOptions OptionsOf(double height) {
  FinderOptions options;
  options.candidates.geometry.height = static_cast<float>(height);
  options.farthest = static_cast<float>(kFarthestDepth);
  return options;
}

// x forward, y left on the floor below the lens.
Box BoxAround(const SeenPerson& person, const Lens& lens, double height) {
  const double forward = std::max<double>(person.position.x(), 0.1);
  const double middle = lens.cx - lens.fx * person.position.y() / forward;
  const double width = lens.fx * kWidth / forward;
  const double top = lens.cy + lens.fy * (height - person.top) / forward;
  const double bottom = lens.cy + lens.fy * height / forward;
  return {middle - width / 2, top, width, bottom - top};
}

PlacedSighting InFrame(const SeenPerson& person, const Ranges& ranges) {
  const Eigen::Isometry3d& optical = ranges.optical_in_frame;
  const Eigen::Vector3d forward = optical.linear().col(2);
  const Eigen::Rotation2Dd turn(std::atan2(forward.y(), forward.x()));
  PlacedSighting placed;
  placed.sighting = {SightingKind::kPerson,
                     BoxAround(person, ranges.lens, optical.translation().z()), person.probability};
  placed.place.position = turn * person.position.cast<double>() + optical.translation().head<2>();
  placed.place.covariance = turn.toRotationMatrix() * person.covariance.cast<double>() *
                            turn.toRotationMatrix().transpose();
  placed.place.by = RangedBy::kDepth;
  return placed;
}

bool HasDetail(const Picture& picture) {
  double sum = 0, squares = 0;
  int count = 0;
  for (int row = 0; row < picture.height; row += kStep) {
    for (int column = 0; column < picture.width; column += kStep) {
      const Colour colour = picture.at(column, row);
      const double bright = (colour[0] + colour[1] + colour[2]) / 3.0;
      sum += bright;
      squares += bright * bright;
      ++count;
    }
  }
  if (count == 0) return false;
  const double mean = sum / count;
  return squares / count - mean * mean >= kLeastDetail * kLeastDetail;
}

// Of the pixels looked at, how many have a distance.
double ShareOfDepth(const DepthPicture& depth) {
  int count = 0, measured = 0;
  for (int row = 0; row < depth.height; row += kStep) {
    for (int column = 0; column < depth.width; column += kStep) {
      ++count;
      measured += depth.at(column, row) > 0 ? 1 : 0;
    }
  }
  return count == 0 ? 0 : static_cast<double>(measured) / count;
}

}  // namespace

std::vector<PlacedSighting> PeopleInPictures::Find(const Picture& colour, const Ranges& ranges) {
  std::vector<PlacedSighting> found = FindInDepth(ranges);
  for (const Sighting& sighting : detector_.Find({colour, &ranges.depth, ranges.lens.fx})) {
    found.push_back({sighting, PlaceOf(sighting, ranges).value_or(Place{})});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const PlacedSighting& a, const PlacedSighting& b) {
                     return a.sighting.confidence > b.sighting.confidence;
                   });
  return found;
}

std::vector<PlacedSighting> PeopleInPictures::FindInDepth(const Ranges& ranges) {
  std::vector<PlacedSighting> found;
  if (ranges.depth.width == 0 || (!finder_ && !classifier_)) return found;
  const FinderOptions options = OptionsOf(ranges.optical_in_frame.translation().z());
  if (!finder_) {
    finder_.emplace(options, std::move(*classifier_));
    classifier_.reset();
  }
  TurnOf(ranges.depth, ranges.lens, options.candidates.geometry, kFarthestDepth, points_);
  for (const SeenPerson& person : finder_->Find(points_)) found.push_back(InFrame(person, ranges));
  return found;
}

// A plain wall has no detail either, but it is at some distance.
bool IsCovered(const Picture& picture, const DepthPicture& depth) {
  return !HasDetail(picture) && ShareOfDepth(depth) < kLeastDepth;
}

}  // namespace coppice::robot::perception
