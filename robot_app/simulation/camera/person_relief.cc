#include "robot_app/simulation/camera/person_relief.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace coppice::robot::simulation {
namespace {

Vec2 SeenFrom(const Pose2& camera, Vec2 point) {
  return Rotated(point - camera.position(), -camera.yaw);
}

// How far forward the ray that goes aside by `slope` a metre first meets the disc.
std::optional<double> MeetDisc(const Disc& disc, double slope) {
  const double a = 1 + slope * slope;
  const double b = disc.center.x + slope * disc.center.y;
  const double c =
      disc.center.x * disc.center.x + disc.center.y * disc.center.y - disc.radius * disc.radius;
  const double root = b * b - a * c;
  if (root < 0 || b <= 0 || c <= 0) return std::nullopt;
  return (b - std::sqrt(root)) / a;
}

}  // namespace

PersonRelief::PersonRelief(const Figure& figure, const Lens& lens, const Pose2& camera,
                           double height)
    : lens_(lens),
      height_(height),
      axis_(SeenFrom(camera, figure.bounds.center).x),
      parts_(figure.parts) {
  for (Pillar& part : parts_) part.disc.center = SeenFrom(camera, part.disc.center);
}

void PersonRelief::LookAlong(int column) {
  met_ = 0;
  const double slope = (lens_.cx - column) / lens_.fx;
  for (const Pillar& part : parts_) {
    const auto depth = MeetDisc(part.disc, slope);
    if (!depth) continue;
    const auto row_of = [&](double z) { return lens_.cy + lens_.fy * (height_ - z) / *depth; };
    stretches_[met_++] = {row_of(part.top), row_of(part.bottom), *depth};
  }
}

double PersonRelief::At(int row) const {
  double nearest = axis_;
  for (std::size_t i = 0; i < met_; ++i) {
    const Stretch& stretch = stretches_[i];
    if (row < stretch.first_row || row > stretch.last_row) continue;
    nearest = std::min(nearest, stretch.depth);
  }
  return nearest;
}

}  // namespace coppice::robot::simulation
