#include "robot_app/simulation/scene/ground.h"

#include <algorithm>

namespace coppice::robot::simulation {
namespace {

double SlopeBetween(const Vec2& a, const Vec2& b) { return (b.y - a.y) / (b.x - a.x); }

}  // namespace

double Ground::Height(double x) const {
  if (profile_.empty()) return 0;
  if (x <= profile_.front().x) return profile_.front().y;
  for (std::size_t i = 1; i < profile_.size(); ++i) {
    const Vec2 &a = profile_[i - 1], &b = profile_[i];
    if (x < b.x) return a.y + (x - a.x) * SlopeBetween(a, b);
  }
  return profile_.back().y;
}

double Ground::Slope(double x) const {
  for (std::size_t i = 1; i < profile_.size(); ++i) {
    if (x >= profile_[i - 1].x && x < profile_[i].x) {
      return SlopeBetween(profile_[i - 1], profile_[i]);
    }
  }
  return 0;
}

// Between two points of the profile both beam and ground are straight: it is enough to look there.
double Ground::Cast(Vec2 origin, Vec2 direction, double height, double max_range) const {
  if (profile_.empty() || direction.x == 0) return max_range;
  const double begin = Height(origin.x) + height, rise = Slope(origin.x) * direction.x;
  const auto gap = [&](double range) {
    return begin + rise * range - Height(origin.x + direction.x * range);
  };
  double last = 0, last_gap = height;
  const auto meets = [&](double range) {
    const double now = gap(range);
    if (now <= 0) return last + (range - last) * last_gap / (last_gap - now);
    last = range;
    last_gap = now;
    return max_range;
  };
  for (std::size_t i = 0; i < profile_.size(); ++i) {
    const Vec2& point = profile_[direction.x > 0 ? i : profile_.size() - 1 - i];
    const double range = (point.x - origin.x) / direction.x;
    if (range <= 0) continue;
    if (range >= max_range) break;
    if (const double met = meets(range); met < max_range) return met;
  }
  return std::min(meets(max_range), max_range);
}

}  // namespace coppice::robot::simulation
