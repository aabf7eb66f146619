#include "editor/render/image.h"

#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace coppice::editor {

Image MakeImage(int width, int height, std::uint32_t color) {
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {width, height, std::vector<std::uint32_t>(count, color)};
}

std::uint64_t HashOf(const Image& image) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const std::uint32_t pixel : image.pixels) hash = (hash ^ pixel) * 1099511628211ULL;
  return hash;
}

Outcome WritePng(const Image& image, const std::string& path) {
  std::vector<unsigned char> bytes;
  bytes.reserve(image.pixels.size() * 3);
  for (const std::uint32_t pixel : image.pixels) {
    for (const int shift : {0, 8, 16}) {
      bytes.push_back(static_cast<unsigned char>(pixel >> shift));
    }
  }
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  png.flags = PNG_IMAGE_FLAG_FAST;
  const std::string beside = path + ".part";
  if (!png_image_write_to_file(&png, beside.c_str(), 0, bytes.data(), 0, nullptr)) {
    return Problem{"cannot write " + beside + ": " + png.message};
  }
  if (std::rename(beside.c_str(), path.c_str()) != 0) {
    return Problem{"cannot write " + path + ": " + std::strerror(errno)};
  }
  return {};
}

}  // namespace coppice::editor
