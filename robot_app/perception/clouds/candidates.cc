#include "robot_app/perception/clouds/candidates.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::perception {
namespace {

constexpr float kWidest = 1.1F;      // a person with a bag and outstretched arms [m]
constexpr float kLowest = 0.5F;      // what ends below is nobody [m]
constexpr float kLargest = 30;       // larger groups are searched no further [m]
constexpr float kHalfPerson = 0.3F;  // from the middle of the head to the shoulder's edge [m]
constexpr std::size_t kLeast = 5;    // cells

struct Size {
  Eigen::Vector2f low{1e6F, 1e6F}, high{-1e6F, -1e6F};
  float top = 0;
  float width() const { return (high - low).norm(); }
};

Size SizeOf(const RangeImage& image, Clusters::Cells cells) {
  Size size;
  for (const std::uint32_t cell : cells) {
    size.low = size.low.cwiseMin(image.points[cell].head<2>());
    size.high = size.high.cwiseMax(image.points[cell].head<2>());
    size.top = std::max(size.top, image.points[cell].z());
  }
  return size;
}

// The outline of a cluster as the sensor sees it: of each column the highest point.
std::vector<std::uint32_t> OutlineOf(const RangeImage& image, Clusters::Cells cells) {
  std::vector<std::uint32_t> tops;
  int last = -1;
  for (const std::uint32_t cell : cells) {  // ascending: a column after the other, upwards
    if (image.column(cell) != last) tops.push_back(cell);
    tops.back() = cell;
    last = image.column(cell);
  }
  return tops;
}

// Where the outline is highest among what is as near as a shoulder.
std::vector<std::uint32_t> Peaks(const RangeImage& image,
                                 const std::vector<std::uint32_t>& outline) {
  std::vector<std::uint32_t> peaks;
  for (const std::uint32_t top : outline) {
    const Eigen::Vector3f& point = image.points[top];
    if (point.z() < 2 * kLowest) continue;
    const bool is_highest = std::none_of(outline.begin(), outline.end(), [&](std::uint32_t other) {
      return (image.points[other].head<2>() - point.head<2>()).norm() < kHalfPerson &&
             (image.points[other].z() > point.z() ||
              (image.points[other].z() == point.z() && other < top));
    });
    if (is_highest) peaks.push_back(top);
  }
  return peaks;
}

void AddPart(const RangeImage& image, Clusters::Cells cells, const Eigen::Vector2f& middle,
             Clusters& candidates) {
  const std::size_t first = candidates.cells.size();
  for (const std::uint32_t cell : cells) {
    if ((image.points[cell].head<2>() - middle).norm() < kHalfPerson) {
      candidates.cells.push_back(cell);
    }
  }
  if (candidates.cells.size() - first < kLeast) {
    candidates.cells.resize(first);
  } else {
    candidates.Close();
  }
}

// Adds what in `clusters` may be one person: what has about the size, and parts of what is larger.
void AddCandidates(const RangeImage& image, const Clusters& clusters, Clusters& candidates) {
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const Clusters::Cells cells = clusters[i];
    const Size size = SizeOf(image, cells);
    if (cells.size() < kLeast || size.top < kLowest || size.width() > kLargest) continue;
    if (size.width() <= kWidest) {
      candidates.cells.insert(candidates.cells.end(), cells.begin(), cells.end());
      candidates.Close();
    }
    if (size.width() <= 2 * kHalfPerson) continue;
    for (const std::uint32_t peak : Peaks(image, OutlineOf(image, cells))) {
      AddPart(image, cells, image.points[peak].head<2>(), candidates);
    }
  }
}

}  // namespace

const Clusters& CandidateFinder::Find(const std::vector<LidarPoint>& points) {
  FillRangeImage(points, options_.geometry, image_);
  FindGround(image_, options_.ground, surfaces_);
  candidates_.clear();
  if (options_.with_depth_steps) {
    ClusterByDepthSteps(image_, surfaces_, options_.depth_steps, clusters_);
    AddCandidates(image_, clusters_, candidates_);
  }
  ClusterByDistance(image_, surfaces_, options_.distance, clusters_);
  AddCandidates(image_, clusters_, candidates_);
  return candidates_;
}

}  // namespace coppice::robot::perception
