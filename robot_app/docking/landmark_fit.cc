#include "robot_app/docking/landmark_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "robot_app/docking/circle_fit.h"

namespace coppice::robot::docking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kIterations = 12;
constexpr double kEdge = 0.02;            // of a leg's end, where a beam may meet either side [m]
constexpr double kEndTolerance = 0.04;    // of the place where a leg ends [m]
constexpr double kEndDeviation = 0.5;     // of the angle of an end, in steps of the scan
constexpr double kMostEndOff = 4;         // of that, in its standard deviations
constexpr double kMostSeenThrough = 0.1;  // share of the beams that should meet it
constexpr double kMostHidden = 0.5;
// Of one that is not known yet.
constexpr double kMostSeenThroughFirst = 0.05;
constexpr double kMostHiddenFirst = 0.2;
constexpr double kMostDeviation = 1.15;  // times the noise, and ...
constexpr double kScatter = 2.5;  // ... standard deviations of that, which beams have by chance
constexpr double kGate = 4;       // times the noise, along a beam: it met the leg
constexpr double kBehind = 2.5;   // the same, two beams in a row: there the leg has ended
constexpr double kFirstOff = 4;   // times the noise, across the leg: that far is the start
constexpr double kOff = 1;
constexpr int kLeastPoints = 8;
constexpr int kLeastOnLeg = 3;

Vector2d Unit(double angle) { return {std::cos(angle), std::sin(angle)}; }
Vector2d Left(const Vector2d& v) { return {-v.y(), v.x()}; }

// One leg: a line from the corner; +1 is the left one, seen from the robot.
struct Leg {
  Leg(const LandmarkShape& shape, const Pose2D& pose, int side)
      : corner(pose.x, pose.y),
        along(Unit(pose.yaw + side * shape.opening / 2)),
        normal(Left(along)) {}

  // Where the beam meets the line of the leg: the range, and how far along from the corner.
  // False if it runs along the leg, or meets it behind the scanner or from behind.
  bool Meet(const Vector2d& beam) {
    const double facing = normal.dot(beam);
    if (std::abs(facing) < 0.05) return false;
    range = normal.dot(corner) / facing;
    at = (beam * range - corner).dot(along);
    incidence = std::abs(facing);
    return range > 0;
  }
  // Of the range by x, y, yaw of the landmark, for the beam that has just met it.
  Vector3d Gradient(const Vector2d& beam) const {
    const double facing = normal.dot(beam);
    const double lever = -along.dot(corner) + range * along.dot(beam);
    return {normal.x() / facing, normal.y() / facing, lever / facing};
  }

  Vector2d corner, along, normal;
  double range = 0, at = 0, incidence = 0;
};

// What a beam that should meet a leg has to do with it.
struct Reading {
  enum Kind { kOn, kNearer, kThrough };
  Kind kind = kOn;
  int side = 0;         // of the leg: 0 the right one, 1 the left one
  double residual = 0;  // measured minus expected, in standard deviations
  Vector2d echo = Vector2d::Zero();
  Vector3d gradient = Vector3d::Zero();
};

// Where the room begins beyond the end of a leg.
struct End {
  enum Kind { kFree, kHidden, kNone };
  Kind kind = kNone;
  Reading reading;  // of its angle, if it is free
};

// All that the scan says of a landmark at one pose.
struct Evidence {
  std::vector<Reading> readings;
  std::array<End, 2> ends;
  int Count(Reading::Kind kind, int side) const {
    return static_cast<int>(std::count_if(
        readings.begin(), readings.end(),
        [&](const Reading& reading) { return reading.kind == kind && reading.side == side; }));
  }
  int Count(Reading::Kind kind) const { return Count(kind, 0) + Count(kind, 1); }
};

class Fitter {
 public:
  Fitter(const LaserScan& scan, const LandmarkSettings& settings)
      : scan_(scan), settings_(settings) {}

  // `off`: how far the landmark may still be from that pose, in times the noise.
  Evidence Look(const Pose2D& pose, double off) const {
    Evidence evidence;
    for (int side = 0; side < 2; ++side) LookAtLeg(pose, side, off, evidence);
    return evidence;
  }

 private:
  // Beam by beam from the corner outwards, until the leg has ended.
  void LookAtLeg(const Pose2D& pose, int side, double off, Evidence& evidence) const {
    const int out = side == 0 ? -1 : 1;
    Leg leg(settings_.shape, pose, out);
    const double to_corner = BeamAt(std::atan2(pose.y, pose.x));
    int last_on = -1;
    int behind = 0;  // in a row
    const int first = static_cast<int>(side == 0 ? std::floor(to_corner) : std::ceil(to_corner));
    for (int i = first; i >= 0 && i < static_cast<int>(scan_.ranges.size()); i += out) {
      const auto index = static_cast<std::size_t>(i);
      if (!scan_.Hit(index) && !scan_.MetNothing(index)) continue;
      const Vector2d beam = Unit(AngleOf(i));
      // The normal points away from the robot on the right, towards it on the left.
      if (leg.normal.dot(beam) * out >= 0 || !leg.Meet(beam)) return;
      const double spacing = leg.range * scan_.angle_increment / leg.incidence;
      const double beyond = leg.at - settings_.shape.leg;
      if (beyond > kEndTolerance + 3 * spacing + kEdge) return;
      const double residual = scan_.Hit(index) ? scan_.ranges[index] - leg.range : 1.0;
      const Reading::Kind kind = KindOf(residual, leg.incidence, off);
      if (leg.at > 0 && beyond < -kEdge) {
        evidence.readings.push_back({kind, side, residual / settings_.noise,
                                     beam * (leg.range + residual),
                                     leg.Gradient(beam) / settings_.noise});
      }
      if (kind == Reading::kOn && !IsBehind(residual, leg.incidence)) last_on = i;
      behind = IsBehind(residual, leg.incidence) ? behind + 1 : 0;
      if (beyond < -kEndTolerance - 1.5 * spacing) continue;
      if (kind == Reading::kNearer) {
        evidence.ends[side].kind = End::kHidden;
        return;
      }
      if (behind < 2 || last_on < 0) continue;
      // Between the last beam that met it and the next one.
      evidence.ends[side] = EndAt(leg, side, AngleOf(last_on + 0.5 * out));
      return;
    }
  }

  End EndAt(const Leg& leg, int side, double angle) const {
    const Vector2d lever = leg.along * settings_.shape.leg;
    const Vector2d end = leg.corner + lever;
    const double bearing = std::atan2(end.y(), end.x());
    const Vector2d aside = Left(Unit(bearing)) / end.norm();
    const double deviation = kEndDeviation * scan_.angle_increment;
    Reading reading;
    reading.side = side;
    reading.residual = NormalizeAngle(angle - bearing) / deviation;
    reading.gradient = Vector3d(aside.x(), aside.y(), aside.dot(Left(lever))) / deviation;
    return {End::kFree, reading};
  }

  Reading::Kind KindOf(double residual, double incidence, double off) const {
    if (std::abs(residual) < (kGate + off / incidence) * settings_.noise) return Reading::kOn;
    return residual < 0 ? Reading::kNearer : Reading::kThrough;
  }

  bool IsBehind(double residual, double incidence) const {
    return residual > (kBehind + kOff / incidence) * settings_.noise;
  }

  double AngleOf(double beam) const { return scan_.angle_min + beam * scan_.angle_increment; }
  double BeamAt(double angle) const { return (angle - scan_.angle_min) / scan_.angle_increment; }

  const LaserScan& scan_;
  const LandmarkSettings& settings_;
};

// The information about x, y, yaw, and what it says where the landmark should go.
Matrix3d Information(const Evidence& evidence, Vector3d& slope) {
  Matrix3d information = Matrix3d::Zero();
  slope.setZero();
  const auto add = [&](const Reading& reading) {
    information += reading.gradient * reading.gradient.transpose();
    slope += reading.gradient * reading.residual;
  };
  for (const Reading& reading : evidence.readings) {
    if (reading.kind == Reading::kOn) add(reading);
  }
  for (const End& end : evidence.ends) {
    if (end.kind == End::kFree) add(end.reading);
  }
  return information;
}

// The room begins where the legs should end; one end may be hidden if the landmark is known
// already.
bool EndsAreFree(const Evidence& evidence, bool is_known) {
  int free = 0;
  for (const End& end : evidence.ends) {
    if (end.kind == End::kNone) return false;
    if (end.kind == End::kHidden) continue;
    if (std::abs(end.reading.residual) > kMostEndOff) return false;
    ++free;
  }
  return free >= (is_known ? 1 : 2);
}

bool IsSeenWell(const Evidence& evidence, bool is_known) {
  const int on = evidence.Count(Reading::kOn);
  const int hidden = evidence.Count(Reading::kNearer);
  const int through = evidence.Count(Reading::kThrough);
  const double all = on + hidden + through;
  return on >= kLeastPoints && evidence.Count(Reading::kOn, 0) >= kLeastOnLeg &&
         evidence.Count(Reading::kOn, 1) >= kLeastOnLeg &&
         through <= (is_known ? kMostSeenThrough : kMostSeenThroughFirst) * all &&
         hidden <= (is_known ? kMostHidden : kMostHiddenFirst) * all;
}

// Root of the mean square of what was measured [m].
double Deviation(const Evidence& evidence, double noise) {
  double square = 0;
  for (const Reading& reading : evidence.readings) {
    if (reading.kind == Reading::kOn) square += reading.residual * reading.residual;
  }
  return noise * std::sqrt(square / evidence.Count(Reading::kOn));
}

bool IsNoise(double deviation, int points, double noise) {
  return deviation < noise * (kMostDeviation + kScatter / std::sqrt(2.0 * points));
}

// A circle explains the echoes better.
bool IsRound(const Evidence& evidence, double deviation) {
  std::vector<Point2D> echoes;
  for (const Reading& reading : evidence.readings) {
    if (reading.kind == Reading::kOn) echoes.push_back({reading.echo.x(), reading.echo.y()});
  }
  return DeviationFromCircle(echoes) < deviation;
}

}  // namespace

std::optional<LandmarkSighting> FitInScan(const LaserScan& scan, const LandmarkSettings& settings,
                                          const Pose2D& start, bool is_known) {
  const Fitter fitter(scan, settings);
  Pose2D pose = start;
  Vector3d slope;
  for (int i = 0; i < kIterations; ++i) {
    const Evidence evidence = fitter.Look(pose, i < kIterations / 2 ? kFirstOff : kOff);
    if (evidence.Count(Reading::kOn) < kLeastPoints) return std::nullopt;
    const Matrix3d information = Information(evidence, slope);
    const Vector3d step = (information + Matrix3d::Identity()).ldlt().solve(slope);
    if (!step.allFinite() || step.head<2>().norm() > 0.5) return std::nullopt;
    pose = {pose.x + step.x(), pose.y + step.y(), NormalizeAngle(pose.yaw + step.z())};
  }
  const Evidence evidence = fitter.Look(pose, kOff);
  if (!IsSeenWell(evidence, is_known) || !EndsAreFree(evidence, is_known)) return std::nullopt;
  LandmarkSighting sighting;
  sighting.pose = pose;
  sighting.points = evidence.Count(Reading::kOn);
  sighting.deviation = Deviation(evidence, settings.noise);
  if (!IsNoise(sighting.deviation, sighting.points, settings.noise)) return std::nullopt;
  if (IsRound(evidence, sighting.deviation)) return std::nullopt;
  sighting.covariance = Information(evidence, slope).inverse();
  if (!sighting.covariance.allFinite()) return std::nullopt;
  return sighting;
}

}  // namespace coppice::robot::docking
