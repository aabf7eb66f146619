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
constexpr double kNewest = 0.1;      // of the mean
constexpr double kUndamaged = 0.01;  // three rows of 480 are the most that a floor showed

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

}  // namespace

double TornShare(const Picture& picture) {
  if (picture.width < kPieces || picture.height < 2) return 0;
  std::vector<int> differences;
  for (int row = 0; row + 1 < picture.height; ++row) {
    differences.push_back(Difference(picture, row));
  }
  const int limit = std::max(kLeastDifference, kTimesUsual * Median(differences));
  const auto torn = std::count_if(differences.begin(), differences.end(),
                                  [limit](int difference) { return difference > limit; });
  return static_cast<double>(torn) / static_cast<double>(differences.size());
}

void TornGauge::Add(const Picture& picture) { share_ += kNewest * (TornShare(picture) - share_); }

bool TornGauge::is_damaged() const { return share_ > kUndamaged; }

}  // namespace coppice::robot::perception
