// What a detector sees in a picture.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_SIGHTING_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_SIGHTING_H_

#include <algorithm>
#include <cstdint>

namespace coppice::robot::perception {

enum class SightingKind : std::uint8_t { kPerson, kFace, kFaceWithMask, kFaceWithoutMask };

/// Upright, in pixels from the picture's upper left corner; it may reach beyond the picture.
struct Box {
  double x = 0, y = 0;  ///< of its upper left corner
  double width = 0, height = 0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  double area() const { return width * height; }
};

/// Of the part that two boxes have in common [pixels^2].
inline double CommonArea(const Box& a, const Box& b) {
  const double wide = std::min(a.right(), b.right()) - std::max(a.x, b.x);
  const double tall = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
  return wide > 0 && tall > 0 ? wide * tall : 0;
}

/// Intersection over union: 1 for the same box, 0 for boxes that do not touch.
inline double Overlap(const Box& a, const Box& b) {
  const double common = CommonArea(a, b);
  return common > 0 ? common / (a.area() + b.area() - common) : 0;
}

/// The share of the smaller box that lies in the other one.
inline double Nesting(const Box& a, const Box& b) {
  const double common = CommonArea(a, b);
  return common > 0 ? common / std::min(a.area(), b.area()) : 0;
}

struct Sighting {
  SightingKind kind = SightingKind::kPerson;
  Box box;                ///< around what is seen, as a person would draw it
  double confidence = 0;  ///< 0..1; comparable only within one detector
};

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_SIGHTING_H_
