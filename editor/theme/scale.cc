#include "editor/theme/scale.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace coppice::editor {

float ShownScale(float chosen, float of_screen) {
  return chosen == kScaleOfScreen ? of_screen : chosen;
}

float NextScale(float shown, int by) {
  constexpr float kSame = 0.01F;
  if (by > 0) {
    const float* const larger =
        std::upper_bound(std::begin(kScales), std::end(kScales), shown + kSame);
    return larger == std::end(kScales) ? *std::rbegin(kScales) : *larger;
  }
  const float* const not_smaller =
      std::lower_bound(std::begin(kScales), std::end(kScales), shown - kSame);
  return not_smaller == std::begin(kScales) ? *not_smaller : *(not_smaller - 1);
}

float NearestScale(float scale) {
  if (!(scale > 0)) return kScaleOfScreen;
  return *std::min_element(std::begin(kScales), std::end(kScales), [scale](float a, float b) {
    return std::fabs(a - scale) < std::fabs(b - scale);
  });
}

}  // namespace coppice::editor
