#include "tests/editor/reference_picture.h"

#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "tests/support/folders.h"

namespace coppice::editor {
namespace {

constexpr int kColorStep = 16;
constexpr int kVisible = 24;               // of 255, in any of the three colours
constexpr double kMostDifferent = 0.0025;  // of all pixels: some letters

std::uint32_t Channel(std::uint32_t pixel, int shift) { return (pixel >> shift) & 0xFFU; }

}  // namespace

Image HalfSize(const Image& image) {
  Image half = MakeImage(image.width / 2, image.height / 2, 0);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      std::uint32_t pixel = 0xFF000000U;
      for (const int shift : {0, 8, 16}) {
        std::uint32_t sum = 0;
        for (const int i : {0, 1}) {
          sum += Channel(image.At(2 * x + i, 2 * y), shift);
          sum += Channel(image.At(2 * x + i, 2 * y + 1), shift);
        }
        pixel |= (sum / 4 / kColorStep * kColorStep) << static_cast<unsigned>(shift);
      }
      half.pixels[static_cast<std::size_t>(y * half.width + x)] = pixel;
    }
  }
  return half;
}

double DifferentPart(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return 1;
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    int most = 0;
    for (const int shift : {0, 8, 16}) {
      most = std::max(most, std::abs(static_cast<int>(Channel(a.pixels[i], shift)) -
                                     static_cast<int>(Channel(b.pixels[i], shift))));
    }
    different += most > kVisible ? 1 : 0;
  }
  return static_cast<double>(different) /
         static_cast<double>(std::max<std::size_t>(a.pixels.size(), 1));
}

std::optional<Image> ReadPng(const std::string& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&png, path.c_str())) return std::nullopt;
  png.format = PNG_FORMAT_RGBA;
  Image image = MakeImage(static_cast<int>(png.width), static_cast<int>(png.height), 0);
  if (!png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr)) return std::nullopt;
  return image;
}

std::string CompareWithReference(const Image& shown, const std::string& name) {
  const std::string path = SourceFolder() + "/tests/editor/reference/" + name + ".png";
  const Image half = HalfSize(shown);
  if (std::getenv("COPPICE_UPDATE_REFERENCE")) return WritePng(half, path).problem();
  const std::optional<Image> reference = ReadPng(path);
  const double part = reference ? DifferentPart(half, *reference) : 1;
  if (part <= kMostDifferent) return {};
  const std::string seen =
      (std::filesystem::temp_directory_path() / ("coppice-" + name + ".png")).string();
  if (const Outcome written = WritePng(half, seen); !written) return written.problem();
  return std::to_string(part * 100) + " % of " + path + " differ from " + seen +
         "; if that is meant, keep it: see tests/editor/reference_picture.h";
}

}  // namespace coppice::editor
