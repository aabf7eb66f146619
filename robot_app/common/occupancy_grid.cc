#include "robot_app/common/occupancy_grid.h"

#include <algorithm>

namespace coppice::robot {
namespace {

/// The lower envelope of parabolas, the one-dimensional transform of the paper. Buffers are kept
/// between lines.
class Envelope {
 public:
  explicit Envelope(int longest) : place_(longest), border_(longest + 1), in_(longest) {}

  /// Replaces `count` squared distances at line[0], line[stride], ... by their transform.
  void Transform(float* line, int count, int stride) {
    for (int i = 0; i < count; ++i) in_[i] = line[static_cast<std::ptrdiff_t>(i) * stride];
    int top = 0;
    place_[0] = 0;
    border_[0] = -kFar;
    border_[1] = kFar;
    for (int q = 1; q < count; ++q) {
      float crossing = Crossing(q, place_[top]);
      while (crossing <= border_[top]) crossing = Crossing(q, place_[--top]);
      place_[++top] = q;
      border_[top] = crossing;
      border_[top + 1] = kFar;
    }
    for (int q = 0, k = 0; q < count; ++q) {
      while (border_[k + 1] < static_cast<float>(q)) ++k;
      const auto apart = static_cast<float>(q - place_[k]);
      line[static_cast<std::ptrdiff_t>(q) * stride] = apart * apart + in_[place_[k]];
    }
  }

 private:
  static constexpr float kFar = 1e18F;

  float Crossing(int q, int p) const {
    const auto fq = static_cast<float>(q);
    const auto fp = static_cast<float>(p);
    return ((in_[q] + fq * fq) - (in_[p] + fp * fp)) / (2 * fq - 2 * fp);
  }

  std::vector<int> place_;
  std::vector<float> border_;
  std::vector<float> in_;
};

}  // namespace

std::vector<float> DistanceTransform(const GridFrame& frame,
                                     const std::vector<std::uint8_t>& blocked, double limit) {
  // Finite and small enough for float arithmetic: farther than any limit is not told apart.
  const auto limit_cells = static_cast<float>(std::ceil(limit / frame.resolution) + 1);
  const float far = limit_cells * limit_cells;
  std::vector<float> squared(frame.size());
  for (int i = 0; i < frame.size(); ++i) squared[i] = blocked[i] != 0 ? 0 : far;
  Envelope envelope(std::max(frame.width, frame.height));
  for (int x = 0; x < frame.width; ++x) {
    envelope.Transform(squared.data() + x, frame.height, frame.width);
  }
  for (int y = 0; y < frame.height; ++y) {
    envelope.Transform(squared.data() + static_cast<std::ptrdiff_t>(y) * frame.width, frame.width,
                       1);
  }
  const auto resolution = static_cast<float>(frame.resolution);
  for (float& value : squared) {
    value = std::min(std::sqrt(value) * resolution, static_cast<float>(limit));
  }
  return squared;
}

}  // namespace coppice::robot
