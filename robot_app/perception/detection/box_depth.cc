#include "robot_app/perception/detection/box_depth.h"

#include <algorithm>
#include <vector>

namespace coppice::robot::perception {
namespace {

constexpr double kRim = 0.2;  // of a box at each side: there it is mostly something else

// A pixel from 0 to `most`.
int Within(double x, int most) { return static_cast<int>(std::clamp(x, 0.0, double(most))); }

}  // namespace

bool HasDepth(const DetectorInput& input) {
  return input.depth != nullptr && input.focal > 0 && input.depth->width == input.colour.width &&
         input.depth->height == input.colour.height;
}

double MedianDepth(const DepthPicture& depth, const Box& box) {
  const int left = Within(box.x + kRim * box.width, depth.width);
  const int right = Within(box.right() - kRim * box.width, depth.width);
  const int bottom = Within(box.bottom() - kRim * box.height, depth.height);
  std::vector<std::uint16_t> measured;
  for (int row = Within(box.y + kRim * box.height, depth.height); row < bottom; ++row) {
    for (int column = left; column < right; ++column) {
      if (depth.at(column, row) > 0) measured.push_back(depth.at(column, row));
    }
  }
  if (measured.empty()) return 0;
  const auto middle = measured.begin() + static_cast<std::ptrdiff_t>(measured.size() / 2);
  std::nth_element(measured.begin(), middle, measured.end());
  return *middle / 1000.0;
}

}  // namespace coppice::robot::perception
