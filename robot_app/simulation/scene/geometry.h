// Points, poses and rectangles of the simulated floor. Metres and radians; x forward, y left,
// angles counter-clockwise (REP-103).
#ifndef COPPICE_ROBOT_APP_SIMULATION_SCENE_GEOMETRY_H_
#define COPPICE_ROBOT_APP_SIMULATION_SCENE_GEOMETRY_H_

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::robot::simulation {

inline constexpr double kPi = 3.14159265358979323846;

struct Vec2 {
  double x = 0;
  double y = 0;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(Vec2 a, double k) { return {a.x * k, a.y * k}; }
inline double Dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
inline double Cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double Length(Vec2 a) { return std::hypot(a.x, a.y); }
inline Vec2 Direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
inline Vec2 Rotated(Vec2 a, double angle) {
  const Vec2 d = Direction(angle);
  return {a.x * d.x - a.y * d.y, a.x * d.y + a.y * d.x};
}

/// The same angle in [-pi, pi].
inline double NormalAngle(double angle) { return std::remainder(angle, 2 * kPi); }

/// A place and heading of one frame in another.
struct Pose2 {
  double x = 0;
  double y = 0;
  double yaw = 0;
  Vec2 position() const { return {x, y}; }
};

/// `b` is given in the frame `a`: the same pose in the frame that `a` is given in.
inline Pose2 Compose(const Pose2& a, const Pose2& b) {
  const Vec2 moved = a.position() + Rotated(b.position(), a.yaw);
  return {moved.x, moved.y, NormalAngle(a.yaw + b.yaw)};
}

inline Pose2 Inverse(const Pose2& a) {
  const Vec2 back = Rotated({-a.x, -a.y}, -a.yaw);
  return {back.x, back.y, NormalAngle(-a.yaw)};
}

struct Segment {
  Vec2 a;
  Vec2 b;
};

/// The distance of a point from the nearest point of a segment.
inline double Distance(Vec2 point, const Segment& segment) {
  const Vec2 along = segment.b - segment.a;
  const double length2 = Dot(along, along);
  const double t = length2 > 0 ? Dot(point - segment.a, along) / length2 : 0;
  return Length(point - (segment.a + along * std::clamp(t, 0.0, 1.0)));
}

/// A rectangle; size.x lies along its own yaw.
struct Rectangle {
  Vec2 center;
  Vec2 size;
  double yaw = 0;
};

inline std::array<Vec2, 4> Corners(const Rectangle& r) {
  const Vec2 u = Rotated({r.size.x / 2, 0}, r.yaw);
  const Vec2 v = Rotated({0, r.size.y / 2}, r.yaw);
  return {r.center - u - v, r.center + u - v, r.center + u + v, r.center - u + v};
}

/// The distance of a point from a filled rectangle; 0 inside it.
inline double Distance(Vec2 point, const Rectangle& r) {
  const Vec2 local = Rotated(point - r.center, -r.yaw);
  return std::hypot(std::max(std::abs(local.x) - r.size.x / 2, 0.0),
                    std::max(std::abs(local.y) - r.size.y / 2, 0.0));
}

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_SCENE_GEOMETRY_H_
