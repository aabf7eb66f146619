// Plane geometry of poses. The type itself is that of the leaves, leaves::Pose2D.
// SI units, angles in rad counter-clockwise (REP-103). All functions are pure.
#ifndef COPPICE_ROBOT_APP_COMMON_POSE2D_H_
#define COPPICE_ROBOT_APP_COMMON_POSE2D_H_

#include <cmath>
#include <optional>
#include <string>

#include "bt_nodes/navigation/pose2d.h"

namespace coppice::robot {

using leaves::Pose2D;

struct Point2D {
  double x = 0;
  double y = 0;
};

/// What a differential drive can do: forwards [m/s] and turn [rad/s].
struct Velocity2D {
  double linear = 0;
  double angular = 0;
};

/// The same angle in (-pi, pi].
double NormalizeAngle(double angle);

/// Distance of the two origins [m].
double Distance(const Pose2D& a, const Pose2D& b);
double Distance(const Point2D& a, const Point2D& b);

/// `local`, given in the frame `frame`, in the frame that `frame` is given in.
Pose2D Compose(const Pose2D& frame, const Pose2D& local);
Point2D Compose(const Pose2D& frame, const Point2D& local);

/// Compose() of many points with one frame, whose sine and cosine are taken once.
class PointComposer {
 public:
  explicit PointComposer(const Pose2D& frame)
      : x_(frame.x), y_(frame.y), cos_(std::cos(frame.yaw)), sin_(std::sin(frame.yaw)) {}

  Point2D operator()(const Point2D& local) const {
    return {x_ + cos_ * local.x - sin_ * local.y, y_ + sin_ * local.x + cos_ * local.y};
  }

 private:
  double x_, y_, cos_, sin_;
};

/// The reverse: `pose` as seen from `frame`, both given in the same frame.
Pose2D RelativeTo(const Pose2D& frame, const Pose2D& pose);
Point2D RelativeTo(const Pose2D& frame, const Point2D& point);

/// Where a unicycle at `pose` is after driving `velocity` for `seconds`: an exact arc.
Pose2D Advance(const Pose2D& pose, const Velocity2D& velocity, double seconds);

/// `target`, but at most `acceleration` * `seconds` away from `current`.
double LimitChange(double current, double target, double acceleration, double seconds);

/// "X Y" and "X Y YAW" with finite numbers and nothing else; nothing otherwise.
std::optional<Point2D> ParsePlace(const std::string& text);
std::optional<Pose2D> ParsePose(const std::string& text);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_POSE2D_H_
