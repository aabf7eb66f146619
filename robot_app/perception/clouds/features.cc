#include "robot_app/perception/clouds/features.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace coppice::robot::perception {
namespace {

constexpr float kSliceHeight = 0.2F;
constexpr float kStep =
    0.3F;  // a neighbour in the picture so much nearer or farther is another [m]

struct Extent {
  float low = 1e6F, high = -1e6F;
  void Add(float value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  float size() const { return std::max(0.0F, high - low); }
};

// The points of a cluster as seen: along the view, across it, up.
struct Seen {
  float distance = 0;  // of the middle from the sensor's foot
  std::vector<Eigen::Vector3f> points;
  Extent along, across, up;
};

Seen Look(const RangeImage& image, Clusters::Cells cells) {
  Seen seen;
  Eigen::Vector2f middle = Eigen::Vector2f::Zero();
  for (const std::uint32_t cell : cells) middle += image.points[cell].head<2>();
  middle /= static_cast<float>(cells.size());
  seen.distance = std::max(middle.norm(), 0.01F);
  const Eigen::Vector2f view = middle / seen.distance;
  seen.points.reserve(cells.size());
  for (const std::uint32_t cell : cells) {
    const Eigen::Vector3f& point = image.points[cell];
    const Eigen::Vector2f off = point.head<2>() - middle;
    seen.points.push_back({off.dot(view), view.x() * off.y() - view.y() * off.x(), point.z()});
    seen.along.Add(seen.points.back().x());
    seen.across.Add(seen.points.back().y());
    seen.up.Add(seen.points.back().z());
  }
  return seen;
}

// The front as a parabola over the way across: how round it is, how it is turned, how even it is.
struct Front {
  float roundness = 0, turn = 0, unevenness = 0;
};

Front FitFront(const Seen& seen) {
  Eigen::Matrix3f a = Eigen::Matrix3f::Identity() * 1e-3F;
  Eigen::Vector3f b = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& point : seen.points) {
    const Eigen::Vector3f row(1, point.y(), point.y() * point.y());
    a += row * row.transpose();
    b += row * point.x();
  }
  const Eigen::Vector3f c = a.ldlt().solve(b);
  float sum = 0;
  for (const Eigen::Vector3f& point : seen.points) {
    const float off = point.x() - (c[0] + point.y() * (c[1] + point.y() * c[2]));
    sum += off * off;
  }
  return {std::clamp(c[2], -20.0F, 20.0F), std::clamp(c[1], -5.0F, 5.0F),
          std::sqrt(sum / static_cast<float>(seen.points.size()))};
}

// What is beside the cluster in the picture, as shares of its left and right edges.
struct Sides {
  float hidden = 0;  // something nearer: the edge is not the cluster's own
  float free = 0;    // something farther, or nothing
};

Sides LookBeside(const RangeImage& image, Clusters::Cells cells) {
  const auto is_inside = [&](std::size_t cell) {
    return std::binary_search(cells.begin(), cells.end(), static_cast<std::uint32_t>(cell));
  };
  Sides sides;
  int edges = 0;
  for (const std::uint32_t cell : cells) {
    for (const int sign : {-1, 1}) {
      const std::size_t beside = image.cell(image.ring(cell), image.column(cell) + sign);
      if (is_inside(beside)) continue;
      ++edges;
      const float range = image.ranges[beside];
      if (range <= 0 || range > image.ranges[cell] + kStep) {
        sides.free += 1;
      } else if (range < image.ranges[cell] - kStep) {
        sides.hidden += 1;
      }
    }
  }
  const float all = static_cast<float>(std::max(edges, 1));
  return {sides.hidden / all, sides.free / all};
}

struct Slice {
  Extent across, along;
  int count = 0;
};

std::array<Slice, kSlices> CutIntoSlices(const Seen& seen) {
  std::array<Slice, kSlices> slices;
  for (const Eigen::Vector3f& point : seen.points) {
    const int i = std::clamp(static_cast<int>(point.z() / kSliceHeight), 0, kSlices - 1);
    slices[i].across.Add(point.y());
    slices[i].along.Add(point.x());
    ++slices[i].count;
  }
  return slices;
}

// Standard deviations: along the longer and the shorter axis on the floor, and up.
Eigen::Vector3f Spread(const Seen& seen) {
  Eigen::Matrix2f flat = Eigen::Matrix2f::Zero();
  float sum = 0, squares = 0;
  for (const Eigen::Vector3f& point : seen.points) {
    flat += point.head<2>() * point.head<2>().transpose();
    sum += point.z();
    squares += point.z() * point.z();
  }
  const float count = static_cast<float>(seen.points.size());
  const Eigen::Vector2f axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2f>(flat / count, Eigen::EigenvaluesOnly)
          .eigenvalues()
          .cwiseMax(0)
          .cwiseSqrt();
  return {axes[1], axes[0], std::sqrt(std::max(0.0F, squares / count - sum * sum / count / count))};
}

// Mean and standard deviation.
Eigen::Vector2f Brightness(const RangeImage& image, Clusters::Cells cells) {
  float sum = 0, squares = 0;
  for (const std::uint32_t cell : cells) {
    sum += image.intensities[cell];
    squares += image.intensities[cell] * image.intensities[cell];
  }
  const float count = static_cast<float>(cells.size());
  return {sum / count, std::sqrt(std::max(0.0F, squares / count - sum * sum / count / count))};
}

}  // namespace

Features Describe(const RangeImage& image, Clusters::Cells cells) {
  const Seen seen = Look(image, cells);
  const Front front = FitFront(seen);
  const Sides sides = LookBeside(image, cells);
  const Eigen::Vector3f spread = Spread(seen);
  const Eigen::Vector2f brightness = Brightness(image, cells);
  const float area = seen.distance * seen.distance * image.geometry.column_step() *
                     image.geometry.ring_step;  // that a point stands for [m2]
  const float count = static_cast<float>(cells.size());
  const float box = std::max(seen.across.size() * seen.up.size(), area);

  Features features{};
  std::size_t next = 0;
  for (const float value :
       {seen.distance, count * area, count * area / box, seen.up.low, seen.up.high, seen.up.size(),
        seen.across.size(), seen.along.size(), spread[0], spread[1], spread[2], front.roundness,
        front.turn, front.unevenness, sides.hidden, sides.free, brightness[0] * 0.01F,
        brightness[1] * 0.01F}) {
    features[next++] = value;
  }
  for (const Slice& slice : CutIntoSlices(seen)) {
    features[next++] = slice.count > 0 ? slice.across.size() : -1;
    features[next++] = slice.count > 0 ? slice.along.size() : -1;
    features[next++] = static_cast<float>(slice.count) / count;
  }
  return features;
}

}  // namespace coppice::robot::perception
