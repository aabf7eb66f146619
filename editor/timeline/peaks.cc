#include "editor/timeline/peaks.h"

#include <algorithm>

namespace coppice::editor {

void Peaks::Add(float number) {
  if (levels_.empty()) levels_.emplace_back();
  levels_[0].push_back(number);
  const std::size_t at = levels_[0].size() - 1;
  std::size_t size = kFan;
  for (std::size_t k = 1; size <= at || k < levels_.size(); ++k, size *= kFan) {
    if (levels_.size() == k) {
      const auto& below = levels_[k - 1];
      levels_.emplace_back(1, *std::max_element(below.begin(), below.begin() + kFan));
    }
    std::vector<float>& level = levels_[k];
    if (level.size() <= at / size) level.push_back(number);
    level.back() = std::max(level.back(), number);
  }
}

void Peaks::RaiseLast(float number) {
  for (std::vector<float>& level : levels_) level.back() = std::max(level.back(), number);
}

float Peaks::Largest(std::size_t first, std::size_t end) const {
  float largest = 0;
  end = std::min(end, size());
  while (first < end) {
    std::size_t size = 1;
    std::size_t level = 0;
    while (level + 1 < levels_.size() && first % (size * kFan) == 0 && first + size * kFan <= end) {
      size *= kFan;
      ++level;
    }
    largest = std::max(largest, levels_[level][first / size]);
    first += size;
  }
  return largest;
}

}  // namespace coppice::editor
