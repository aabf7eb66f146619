#include <cstdlib>

#include "robot_app/common/compressed_picture.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {
namespace {

using robot::kMostPixels;

template <class Decoded>
int Checked(const Decoded& picture, std::size_t size, std::size_t per_pixel) {
  const bool is_picture = picture.width > 0 && picture.height > 0;
  const auto pixels = static_cast<std::size_t>(picture.width) * picture.height;
  if (!is_picture || pixels > kMostPixels || size != per_pixel * pixels) std::abort();
  return 1;
}

}  // namespace

int FuzzPicture(std::string_view bytes) {
  if (bytes.empty()) return 0;
  const std::vector<std::uint8_t> rest(bytes.begin() + 1, bytes.end());
  if (bytes.front() == 'D') {
    const auto depth = robot::DecodeDepth(rest);
    return depth ? Checked(*depth, depth->millimetres.size(), 1) : 0;
  }
  const auto colour = robot::DecodeJpeg(rest);
  return colour ? Checked(*colour, colour->rgb.size(), 3) : 0;
}

}  // namespace coppice::fuzz
