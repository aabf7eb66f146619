#include "robot_app/docking/dubins.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace coppice::robot::docking {
namespace {

constexpr double kFull = 2 * M_PI;
// An arc that is that short, or that near to a full circle, is none; nor is such a straight
// stretch.
constexpr double kNone = 1e-6;

double Turned(double angle) {
  const double turned = std::fmod(std::fmod(angle, kFull) + kFull, kFull);
  return turned > kFull - kNone ? 0 : turned;
}

// Lengths of the three parts for the radius 1.
using Lengths = std::array<double, 3>;

// From the origin, heading `a`, to the point (d, 0), heading `b`.
class Words {
 public:
  Words(double d, double a, double b)
      : d_(d),
        a_(a),
        b_(b),
        sa_(std::sin(a)),
        sb_(std::sin(b)),
        ca_(std::cos(a)),
        cb_(std::cos(b)) {}

  std::optional<Lengths> Lsl() const {
    const auto p = Root(2 + d_ * d_ - 2 * Cab() + 2 * d_ * (sa_ - sb_));
    if (!p) return std::nullopt;
    if (*p < kNone) return Lengths{Turned(b_ - a_), 0, 0};  // a single arc
    const double t = std::atan2(cb_ - ca_, d_ + sa_ - sb_);
    return Lengths{Turned(t - a_), *p, Turned(b_ - t)};
  }
  std::optional<Lengths> Rsr() const {
    const auto p = Root(2 + d_ * d_ - 2 * Cab() + 2 * d_ * (sb_ - sa_));
    if (!p) return std::nullopt;
    if (*p < kNone) return Lengths{Turned(a_ - b_), 0, 0};
    const double t = std::atan2(ca_ - cb_, d_ - sa_ + sb_);
    return Lengths{Turned(a_ - t), *p, Turned(t - b_)};
  }
  std::optional<Lengths> Lsr() const {
    const auto p = Root(-2 + d_ * d_ + 2 * Cab() + 2 * d_ * (sa_ + sb_));
    if (!p) return std::nullopt;
    const double t = std::atan2(-ca_ - cb_, d_ + sa_ + sb_) - std::atan2(-2.0, *p);
    return Lengths{Turned(t - a_), *p, Turned(t - b_)};
  }
  std::optional<Lengths> Rsl() const {
    const auto p = Root(-2 + d_ * d_ + 2 * Cab() - 2 * d_ * (sa_ + sb_));
    if (!p) return std::nullopt;
    const double t = std::atan2(ca_ + cb_, d_ - sa_ - sb_) - std::atan2(2.0, *p);
    return Lengths{Turned(a_ - t), *p, Turned(b_ - t)};
  }
  std::optional<Lengths> Rlr() const {
    const double cosine = (6 - d_ * d_ + 2 * Cab() + 2 * d_ * (sa_ - sb_)) / 8;
    if (std::abs(cosine) > 1) return std::nullopt;
    const double p = Turned(kFull - std::acos(cosine));
    const double t = Turned(a_ - std::atan2(ca_ - cb_, d_ - sa_ + sb_) + p / 2);
    return Lengths{t, p, Turned(a_ - b_ - t + p)};
  }
  std::optional<Lengths> Lrl() const {
    const double cosine = (6 - d_ * d_ + 2 * Cab() + 2 * d_ * (sb_ - sa_)) / 8;
    if (std::abs(cosine) > 1) return std::nullopt;
    const double p = Turned(kFull - std::acos(cosine));
    const double t = Turned(-a_ + std::atan2(cb_ - ca_, d_ + sa_ - sb_) + p / 2);
    return Lengths{t, p, Turned(b_ - a_ - t + p)};
  }

 private:
  static std::optional<double> Root(double square) {
    if (square < -kNone) return std::nullopt;
    return std::sqrt(std::max(0.0, square));
  }
  double Cab() const { return std::cos(a_ - b_); }

  double d_, a_, b_, sa_, sb_, ca_, cb_;
};

void Add(const std::array<int, 3>& turns, const std::optional<Lengths>& lengths, const Pose2D& from,
         double radius, std::vector<DubinsPath>& paths) {
  if (!lengths) return;
  DubinsPath path{from, radius, {}};
  for (std::size_t i = 0; i < 3; ++i) path.parts[i] = {turns[i], (*lengths)[i] * radius};
  paths.push_back(path);
}

}  // namespace

double DubinsPath::length() const { return parts[0].length + parts[1].length + parts[2].length; }

Pose2D DubinsPath::At(double way) const {
  Pose2D pose = from;
  for (const Part& part : parts) {
    const double here = std::clamp(way, 0.0, part.length);
    pose = Advance(pose, {1, part.turn / radius}, here);
    way -= here;
  }
  return pose;
}

std::string DubinsPath::word() const {
  std::string word;
  for (const Part& part : parts) word += part.turn == 0 ? 'S' : part.turn > 0 ? 'L' : 'R';
  return word;
}

std::vector<DubinsPath> DubinsPaths(const Pose2D& from, const Pose2D& to, double radius) {
  const double direction = std::atan2(to.y - from.y, to.x - from.x);
  const Words words(Distance(from, to) / radius, Turned(from.yaw - direction),
                    Turned(to.yaw - direction));
  std::vector<DubinsPath> paths;
  Add({1, 0, 1}, words.Lsl(), from, radius, paths);
  Add({-1, 0, -1}, words.Rsr(), from, radius, paths);
  Add({1, 0, -1}, words.Lsr(), from, radius, paths);
  Add({-1, 0, 1}, words.Rsl(), from, radius, paths);
  Add({-1, 1, -1}, words.Rlr(), from, radius, paths);
  Add({1, -1, 1}, words.Lrl(), from, radius, paths);
  std::stable_sort(paths.begin(), paths.end(), [](const DubinsPath& a, const DubinsPath& b) {
    return a.length() < b.length();
  });
  return paths;
}

}  // namespace coppice::robot::docking
