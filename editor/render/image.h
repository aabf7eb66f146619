// A picture in memory, and as a PNG file.
#ifndef COPPICE_EDITOR_RENDER_IMAGE_H_
#define COPPICE_EDITOR_RENDER_IMAGE_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"

namespace coppice::editor {

/// Rows from top to bottom; a pixel is 0xAABBGGRR, so its bytes in memory are R, G, B, A.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;

  std::uint32_t At(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// An image of one colour.
Image MakeImage(int width, int height, std::uint32_t color);

/// A number that differs when the pictures differ (FNV-1a over all pixels).
std::uint64_t HashOf(const Image& image);

/// Writes a PNG without alpha. A reader never sees half a file: it is written beside `path` and
/// then renamed.
Outcome WritePng(const Image& image, const std::string& path);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_RENDER_IMAGE_H_
