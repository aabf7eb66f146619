#include "editor/timeline/peaks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace coppice::editor {
namespace {

TEST(PeaksTest, FindsTheLargestOfAnyRange) {
  std::mt19937 random(3);
  Peaks peaks;
  std::vector<float> all;
  for (int i = 0; i < 5000; ++i) {
    const auto number = static_cast<float>(random() % 1000);
    peaks.Add(number);
    all.push_back(number);
    if (random() % 5 == 0) {
      peaks.RaiseLast(number + 7);
      all.back() = number + 7;
    }
    const std::size_t first = random() % all.size();
    const std::size_t end = first + 1 + random() % 600;
    const auto last = all.begin() + static_cast<std::ptrdiff_t>(std::min(end, all.size()));
    ASSERT_EQ(peaks.Largest(first, end),
              *std::max_element(all.begin() + static_cast<std::ptrdiff_t>(first), last))
        << first << " to " << end;
  }
  EXPECT_EQ(peaks.Largest(10, 10), 0);
  EXPECT_EQ(Peaks().Largest(0, 10), 0);
}

}  // namespace
}  // namespace coppice::editor
