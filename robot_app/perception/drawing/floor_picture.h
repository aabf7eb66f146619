// A part of the floor seen from above, with who is on it: for manuals, and for looking into a
// record.
//
//   FloorPicture picture({0, 0}, 6);
//   picture.DrawPoints(points, ColourOf(3));
//   picture.DrawPerson({2, 1}, {0.5, 0}, "3", ColourOf(3));
//   EncodeJpeg(picture.picture());
//
// Metres in one frame; its x goes to the right in the picture, its y up.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DRAWING_FLOOR_PICTURE_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DRAWING_FLOOR_PICTURE_H_

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "robot_app/common/picture.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot::perception {

/// Well apart for numbers that follow each other.
Colour ColourOf(std::uint32_t number);

inline constexpr Colour kGray{160, 160, 160};

class FloorPicture {
 public:
  /// White with circles every two metres: the square of twice `reach` around `middle`.
  FloorPicture(const Eigen::Vector2d& middle, double reach, int pixels = 800);

  void DrawPoints(const std::vector<Eigen::Vector2d>& points, const Colour& colour);
  void DrawWall(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  /// Where somebody went.
  void DrawTrail(const std::vector<Eigen::Vector2d>& trail, const Colour& colour);
  /// A circle of a body's size, an arrow as far as he comes in a second, and a text beside.
  void DrawPerson(const Eigen::Vector2d& at, const Eigen::Vector2d& velocity,
                  const std::string& text, const Colour& colour);
  void DrawRobot(const Pose2D& pose);
  /// Below everything.
  void Write(const std::string& text);

  const Picture& picture() const { return picture_; }

 private:
  struct Pixel {
    int x, y;
  };
  Pixel At(const Eigen::Vector2d& point) const;

  Eigen::Vector2d middle_;
  double pixels_per_metre_;
  Picture picture_;
};

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DRAWING_FLOOR_PICTURE_H_
