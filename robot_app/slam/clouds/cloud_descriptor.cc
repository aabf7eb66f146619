#include "robot_app/slam/clouds/cloud_descriptor.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace coppice::robot::slam {
namespace {

constexpr float kFloor = 0.15F;       // m: lower is the floor
constexpr float kUpright = 0.9F;      // m: higher is no chair and no desk,
constexpr float kCeiling = 2.3F;      // and lower than this no ceiling
constexpr float kNear = 0.5F;         // m: the robot itself
constexpr float kFar = 40;            // m
constexpr float kJump = 0.6F;         // m, between two sectors: an edge
constexpr std::size_t kWaves = 12;    // of the contour's spectrum
constexpr double kSameTurn = 0.2618;  // rad
constexpr double kPi = 3.14159265358979323846;
constexpr double kSector = 2 * kPi / kSectors;

using Contour = std::array<float, kSectors>;

Contour ContourOf(const CloudPoints& points) {
  Contour contour{};
  for (const Eigen::Vector3f& point : points) {
    if (point.z() < kUpright || point.z() > kCeiling) continue;
    const float range = std::min(point.head<2>().norm(), kFar);
    const double angle = std::atan2(point.y(), point.x()) + kPi;
    const std::size_t sector = std::min(static_cast<std::size_t>(angle / kSector), kSectors - 1);
    contour[sector] = std::max(contour[sector], range);
  }
  return contour;
}

// Fills the scalars one after the other.
class Scalars {
 public:
  explicit Scalars(std::array<float, kScalars>& to) : to_(to) {}
  void Add(double value) { to_[next_++] = static_cast<float>(value); }

 private:
  std::array<float, kScalars>& to_;
  std::size_t next_ = 0;
};

struct Moments {
  double mean = 0;
  double deviation = 0;
};

template <typename Values>
Moments MomentsOf(const Values& values) {
  double sum = 0, squares = 0;
  for (const float value : values) {
    sum += value;
    squares += static_cast<double>(value) * value;
  }
  const double count = std::max<double>(static_cast<double>(values.size()), 1);
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0))};
}

Eigen::Vector2d CornerOf(const Contour& contour, std::size_t sector) {
  const double angle = -kPi + (static_cast<double>(sector) + 0.5) * kSector;
  return contour[sector] * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

// What a walker along the contour could measure: area, length, edges, how far its middle is away.
void AddShape(const Contour& contour, Scalars& scalars) {
  double area = 0, length = 0, longest = 0;
  int jumps = 0, empty = 0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < kSectors; ++i) {
    const std::size_t next = (i + 1) % kSectors;
    const Eigen::Vector2d a = CornerOf(contour, i), b = CornerOf(contour, next);
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
    middle += a / kSectors;
    const double step = (b - a).norm();
    length += step;
    longest = std::max(longest, static_cast<double>(contour[i]));
    jumps += std::abs(contour[i] - contour[next]) > kJump ? 1 : 0;
    empty += contour[i] == 0 ? 1 : 0;
  }
  const Moments ranges = MomentsOf(contour);
  for (const double value : {std::sqrt(std::abs(area)), length, area / (length * length + 1e-6),
                             longest, ranges.mean, ranges.deviation, middle.norm()}) {
    scalars.Add(value);
  }
  scalars.Add(jumps);
  scalars.Add(empty);
}

// The size of each wave does not depend on where the contour begins.
void AddSpectrum(const Contour& contour, Scalars& scalars) {
  for (std::size_t wave = 1; wave <= kWaves; ++wave) {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < kSectors; ++i) {
      // Logarithms, so that a far wall in one sector does not decide alone.
      sum += std::log1p(static_cast<double>(contour[i])) *
             std::polar(1.0, static_cast<double>(wave * i) * kSector);
    }
    scalars.Add(std::abs(sum) / kSectors);
  }
}

struct PointValues {
  std::vector<float> ranges;  // on the floor
  std::vector<float> heights;
};

PointValues ValuesOf(const CloudPoints& points) {
  PointValues values;
  for (const Eigen::Vector3f& point : points) {
    const float range = point.head<2>().norm();
    if (range < kNear || range > kFar || point.z() < kFloor) continue;
    values.ranges.push_back(range);
    values.heights.push_back(point.z());
  }
  return values;
}

void AddPoints(const PointValues& values, std::size_t all, Scalars& scalars) {
  const Moments ranges = MomentsOf(values.ranges), heights = MomentsOf(values.heights);
  for (const double value : {ranges.mean, ranges.deviation, heights.mean, heights.deviation}) {
    scalars.Add(value);
  }
  const double count = std::max<double>(static_cast<double>(values.ranges.size()), 1);
  scalars.Add(count / std::max<double>(static_cast<double>(all), 1));
  for (const float nearer : {1.5F, 3.0F, 6.0F}) {
    scalars.Add(std::count_if(values.ranges.begin(), values.ranges.end(),
                              [nearer](float range) { return range < nearer; }) /
                count);
  }
  for (const float lower : {0.6F, 1.1F}) {
    scalars.Add(std::count_if(values.heights.begin(), values.heights.end(),
                              [lower](float height) { return height < lower; }) /
                count);
  }
}

std::array<float, kBins> HistogramOf(const std::vector<float>& values, float bin) {
  std::array<float, kBins> histogram{};
  const float share = 1 / std::max<float>(static_cast<float>(values.size()), 1);
  for (const float value : values) {
    histogram[std::min(static_cast<std::size_t>(value / bin), kBins - 1)] += share;
  }
  return histogram;
}

// Correlation coefficient.
float Correlation(const std::array<float, kBins>& a, const std::array<float, kBins>& b) {
  const Moments of_a = MomentsOf(a), of_b = MomentsOf(b);
  double sum = 0;
  for (std::size_t i = 0; i < kBins; ++i) sum += (a[i] - of_a.mean) * (b[i] - of_b.mean);
  return static_cast<float>(sum / kBins / std::max(of_a.deviation * of_b.deviation, 1e-9));
}

// How far the contours are apart, on average of the sectors, if b is turned by so many [ln m].
double Apart(const Contour& a, const Contour& b, std::size_t sectors) {
  double sum = 0;
  for (std::size_t i = 0; i < kSectors; ++i) {
    sum += std::min(std::abs(std::log1p(a[(i + sectors) % kSectors]) - std::log1p(b[i])), 1.0F);
  }
  return sum / kSectors;
}

std::array<double, kSectors> ApartByTurn(const CloudDescriptor& a, const CloudDescriptor& b) {
  std::array<double, kSectors> apart{};
  for (std::size_t i = 0; i < kSectors; ++i) apart[i] = Apart(a.contour, b.contour, i);
  return apart;
}

}  // namespace

CloudDescriptor Describe(const CloudPoints& points) {
  CloudDescriptor descriptor;
  descriptor.contour = ContourOf(points);
  const PointValues values = ValuesOf(points);
  Scalars scalars(descriptor.scalars);
  AddShape(descriptor.contour, scalars);
  AddSpectrum(descriptor.contour, scalars);
  AddPoints(values, points.size(), scalars);
  descriptor.histograms = {HistogramOf(values.ranges, 0.25F), HistogramOf(values.ranges, 0.5F),
                           HistogramOf(values.ranges, 1), HistogramOf(values.heights, 0.1F)};
  return descriptor;
}

PairFeatures Compare(const CloudDescriptor& a, const CloudDescriptor& b) {
  PairFeatures features{};
  for (std::size_t i = 0; i < kScalars; ++i) {
    features[i] = std::abs(a.scalars[i] - b.scalars[i]);
  }
  for (std::size_t i = 0; i < kHistograms; ++i) {
    features[kScalars + i] = Correlation(a.histograms[i], b.histograms[i]);
  }
  const auto apart = ApartByTurn(a, b);
  features.back() = static_cast<float>(*std::min_element(apart.begin(), apart.end()));
  return features;
}

std::vector<double> LikelyTurns(const CloudDescriptor& a, const CloudDescriptor& b,
                                std::size_t most) {
  const auto apart = ApartByTurn(a, b);
  std::array<std::size_t, kSectors> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t k) { return apart[i] < apart[k]; });
  std::vector<double> turns;
  for (const std::size_t sectors : order) {
    if (turns.size() == most) break;
    const double turn = std::remainder(static_cast<double>(sectors) * kSector, 2 * kPi);
    const auto is_same = [turn](double other) {
      return std::abs(std::remainder(turn - other, 2 * kPi)) < kSameTurn;
    };
    if (std::none_of(turns.begin(), turns.end(), is_same)) turns.push_back(turn);
  }
  return turns;
}

}  // namespace coppice::robot::slam
