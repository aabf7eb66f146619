#include "robot_app/docking/line_segments.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coppice::robot::docking {
namespace {

constexpr double kFlattest = 8 * M_PI / 180;  // a surface at a smaller angle to the beam ends
constexpr double kPrice = 20;                 // of a line, in squared standard deviations
constexpr std::size_t kFinest = 2000;         // of a finer scan not all: cutting takes their square

struct Echo {
  int beam = 0;
  double range = 0;
  Point2D at;
};

// Echoes [first, last].
struct Stretch {
  int first = 0;
  int last = 0;
};

struct Line {
  Point2D middle;
  Point2D along;       // of length 1
  double squares = 0;  // sum of the squared deviations [m^2]
};

std::vector<Echo> EchoesOf(const LaserScan& scan, double limit) {
  std::vector<Echo> echoes;
  const std::size_t every = std::max<std::size_t>(1, scan.ranges.size() / kFinest);
  for (std::size_t i = 0; i < scan.ranges.size(); i += every) {
    if (!scan.Hit(i) || scan.ranges[i] > limit) continue;
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const double range = scan.ranges[i];
    echoes.push_back(
        {static_cast<int>(i), range, {range * std::cos(angle), range * std::sin(angle)}});
  }
  return echoes;
}

// Total least squares over any stretch, in constant time.
class Lines {
 public:
  explicit Lines(const std::vector<Echo>& echoes) : sums_(echoes.size() + 1) {
    for (std::size_t i = 0; i < echoes.size(); ++i) {
      const Point2D p = echoes[i].at;
      const Sums& s = sums_[i];
      sums_[i + 1] = {s.x + p.x, s.y + p.y, s.xx + p.x * p.x, s.xy + p.x * p.y, s.yy + p.y * p.y};
    }
  }

  Line Fit(const Stretch& stretch) const {
    const Sums& a = sums_[static_cast<std::size_t>(stretch.first)];
    const Sums& b = sums_[static_cast<std::size_t>(stretch.last) + 1];
    const double count = stretch.last - stretch.first + 1;
    Line line;
    line.middle = {(b.x - a.x) / count, (b.y - a.y) / count};
    const double xx = b.xx - a.xx - count * line.middle.x * line.middle.x;
    const double xy = b.xy - a.xy - count * line.middle.x * line.middle.y;
    const double yy = b.yy - a.yy - count * line.middle.y * line.middle.y;
    const double angle = std::atan2(2 * xy, xx - yy) / 2;
    line.along = {std::cos(angle), std::sin(angle)};
    line.squares = std::max(0.0, (xx + yy - std::hypot(xx - yy, 2 * xy)) / 2);
    return line;
  }

 private:
  struct Sums {
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  };
  std::vector<Sums> sums_;  // of the echoes before
};

bool AreOneSurface(const Echo& a, const Echo& b, double step, double noise) {
  const double turn = (b.beam - a.beam) * step;
  if (turn >= kFlattest) return false;
  const double jump = a.range * std::sin(turn) / std::sin(kFlattest - turn) + 3 * noise;
  return Distance(a.at, b.at) < jump;
}

std::vector<Stretch> SurfacesOf(const std::vector<Echo>& echoes, double step, double noise) {
  std::vector<Stretch> surfaces;
  for (int i = 0; i < static_cast<int>(echoes.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (i > 0 && AreOneSurface(echoes[at - 1], echoes[at], step, noise)) {
      surfaces.back().last = i;
    } else {
      surfaces.push_back({i, i});
    }
  }
  return surfaces;
}

// The cheapest way to cut a surface, by dynamic programming over where its last line begins.
std::vector<Stretch> Cut(const Stretch& surface, const Lines& lines, double noise) {
  const int count = surface.last - surface.first + 1;
  std::vector<double> cost(static_cast<std::size_t>(count) + 1, 0);  // of the first i echoes
  std::vector<int> begin(static_cast<std::size_t>(count) + 1, 0);    // of the last line of these
  for (int i = 1; i <= count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    cost[at] = std::numeric_limits<double>::infinity();
    for (int j = 0; j < i; ++j) {
      const Stretch line{surface.first + j, surface.first + i - 1};
      const double price =
          cost[static_cast<std::size_t>(j)] + kPrice + lines.Fit(line).squares / (noise * noise);
      if (price >= cost[at]) continue;
      cost[at] = price;
      begin[at] = j;
    }
  }
  std::vector<Stretch> parts;
  for (int end = count; end > 0; end = begin[static_cast<std::size_t>(end)]) {
    parts.push_back(
        {surface.first + begin[static_cast<std::size_t>(end)], surface.first + end - 1});
  }
  std::reverse(parts.begin(), parts.end());
  return parts;
}

Point2D OnLine(const Line& line, const Point2D& point) {
  const double along =
      (point.x - line.middle.x) * line.along.x + (point.y - line.middle.y) * line.along.y;
  return {line.middle.x + along * line.along.x, line.middle.y + along * line.along.y};
}

}  // namespace

std::vector<LineSegment> FindSegments(const LaserScan& scan, double noise, double limit) {
  const std::vector<Echo> echoes = EchoesOf(scan, limit);
  const Lines lines(echoes);
  std::vector<LineSegment> segments;
  for (const Stretch& surface : SurfacesOf(echoes, scan.angle_increment, noise)) {
    for (const Stretch& part : Cut(surface, lines, noise)) {
      if (part.first == part.last) continue;
      const Line line = lines.Fit(part);
      segments.push_back({OnLine(line, echoes[static_cast<std::size_t>(part.first)].at),
                          OnLine(line, echoes[static_cast<std::size_t>(part.last)].at),
                          part.last - part.first + 1});
    }
  }
  return segments;
}

}  // namespace coppice::robot::docking
