#include "robot_app/common/occupancy_grid.h"

#include <algorithm>

namespace coppice::robot {
namespace {

/// The lower envelope of parabolas, the one-dimensional transform of the paper. Cells of the height
/// `far` raise none. Buffers are kept between lines.
class Envelope {
 public:
  Envelope(int longest, float far)
      : far_(far), place_(longest), height_(longest), border_(longest + 1) {}

  /// Replaces `count` squared distances, at most far, by their transform.
  void Transform(float* line, int count) {
    int parabolas = 0;
    for (int q = 0; q < count; ++q) {
      if (line[q] >= far_) continue;
      float from = -kEverywhere;
      while (parabolas > 0) {
        from = Crossing(line, q, place_[parabolas - 1]);
        if (from > border_[parabolas - 1]) break;
        if (--parabolas == 0) from = -kEverywhere;
      }
      place_[parabolas] = q;
      height_[parabolas] = line[q];
      border_[parabolas++] = from;
    }
    if (parabolas == 0) return;
    border_[parabolas] = kEverywhere;
    for (int q = 0, k = 0; q < count; ++q) {
      while (border_[k + 1] < static_cast<float>(q)) ++k;
      const auto apart = static_cast<float>(q - place_[k]);
      line[q] = std::min(far_, apart * apart + height_[k]);
    }
  }

 private:
  static constexpr float kEverywhere = 1e18F;

  static float Crossing(const float* line, int q, int p) {
    const auto fq = static_cast<float>(q);
    const auto fp = static_cast<float>(p);
    return ((line[q] + fq * fq) - (line[p] + fp * fp)) / (2 * fq - 2 * fp);
  }

  const float far_;
  std::vector<int> place_;
  std::vector<float> height_;
  std::vector<float> border_;  // from where on each is the lowest
};

/// Cells up or down to the nearest blocked one of the same column, at most `most`. All columns at a
/// time, row by row.
std::vector<float> AlongColumns(const GridFrame& frame, const std::vector<std::uint8_t>& blocked,
                                float most) {
  std::vector<float> apart(frame.size(), most);
  for (int i = 0; i < frame.size(); ++i) {
    const float before = i < frame.width ? most : apart[i - frame.width];
    apart[i] = blocked[i] != 0 ? 0 : std::min(most, before + 1);
  }
  for (int i = frame.size() - frame.width - 1; i >= 0; --i) {
    apart[i] = std::min(apart[i], apart[i + frame.width] + 1);
  }
  return apart;
}

}  // namespace

std::vector<float> DistanceTransform(const GridFrame& frame,
                                     const std::vector<std::uint8_t>& blocked, double limit) {
  // Farther than any limit is not told apart.
  const auto limit_cells = static_cast<float>(std::ceil(limit / frame.resolution) + 1);
  std::vector<float> squared = AlongColumns(frame, blocked, limit_cells);
  for (float& value : squared) value *= value;
  Envelope envelope(frame.width, limit_cells * limit_cells);
  for (int y = 0; y < frame.height; ++y) {
    envelope.Transform(squared.data() + static_cast<std::ptrdiff_t>(y) * frame.width, frame.width);
  }
  const auto resolution = static_cast<float>(frame.resolution);
  for (float& value : squared) {
    value = std::min(std::sqrt(value) * resolution, static_cast<float>(limit));
  }
  return squared;
}

}  // namespace coppice::robot
