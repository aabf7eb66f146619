#include "robot_app/perception/camera/damaged_rows.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace coppice::robot::perception {
namespace {

constexpr int kPieces = 8;            // across the picture
constexpr int kLeastDifference = 10;  // grey levels; noise and JPEG make less
constexpr int kTimesUsual = 4;
constexpr double kNewest = 0.1;  // of the mean
constexpr double kUndamaged = 0.005;

int Median(std::vector<int> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Per pixel, in the middle one of the pieces of the width: an edge that does not go all along is
// not seen.
int Difference(const Picture& picture, int row) {
  const int piece = 3 * (picture.width / kPieces);
  const std::uint8_t* upper =
      picture.rgb.data() + static_cast<std::size_t>(3) * row * picture.width;
  const std::uint8_t* lower = upper + static_cast<std::size_t>(3) * picture.width;
  std::vector<int> pieces(kPieces, 0);
  for (int& sum : pieces) {
    for (int i = 0; i < piece; ++i) sum += std::abs(*upper++ - *lower++);
    sum /= piece;
  }
  return Median(std::move(pieces));
}

bool HasDepth(const DepthPicture& depth, int row) {
  const auto first = depth.millimetres.begin() + static_cast<std::ptrdiff_t>(row) * depth.width;
  return std::any_of(first, first + depth.width, [](std::uint16_t range) { return range != 0; });
}

}  // namespace

double TornShare(const Picture& picture, const DepthPicture& depth) {
  if (picture.width < kPieces || picture.height < 2) return 0;
  if (depth.width != picture.width || depth.height != picture.height) return 0;
  std::vector<int> differences;
  for (int row = 0; row + 1 < picture.height; ++row) {
    differences.push_back(Difference(picture, row));
  }
  const int limit = std::max(kLeastDifference, kTimesUsual * Median(differences));
  int torn = 0;
  for (int row = 0; row + 1 < picture.height; ++row) {
    if (differences[static_cast<std::size_t>(row)] <= limit) continue;
    if (HasDepth(depth, row) != HasDepth(depth, row + 1)) ++torn;
  }
  return static_cast<double>(torn) / (picture.height - 1);
}

void TornGauge::Add(const Picture& picture, const DepthPicture& depth) {
  share_ += kNewest * (TornShare(picture, depth) - share_);
}

bool TornGauge::is_damaged() const { return share_ > kUndamaged; }

}  // namespace coppice::robot::perception
