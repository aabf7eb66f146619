#include "robot_app/mapping/gray_picture.h"

#include <filesystem>
#include <fstream>
#include <limits>

namespace coppice::robot::mapping {
namespace {

constexpr std::int64_t kMostPixels = 64'000'000;  // a map takes three times as many bytes

// The next number of the header; 0 if there is none. Comments begin with #.
int NextNumber(std::istream& stream) {
  while ((stream >> std::ws) && stream.peek() == '#') {
    stream.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  int number = 0;
  return stream >> number && number > 0 ? number : 0;
}

}  // namespace

std::string ToPgm(const GrayPicture& picture) {
  std::string text =
      "P5\n" + std::to_string(picture.width) + " " + std::to_string(picture.height) + "\n255\n";
  text.append(picture.pixels.begin(), picture.pixels.end());
  return text;
}

std::optional<GrayPicture> LoadPgm(const std::string& path, Diagnostics& diagnostics) {
  const auto fail = [&](const std::string& reason) {
    diagnostics.Error({path, 0, 0}, reason);
    return std::nullopt;
  };
  std::error_code error;
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error)) {
    return fail("is a device or a pipe, and no file");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return fail("cannot be opened");
  char magic[2] = {};
  stream.read(magic, 2);
  if (magic[0] != 'P' || magic[1] != '5') return fail("is no PGM file (P5)");
  GrayPicture picture;
  picture.width = NextNumber(stream);
  picture.height = NextNumber(stream);
  const int white = NextNumber(stream);
  stream.get();  // one blank ends the header
  const std::int64_t pixels = std::int64_t{picture.width} * picture.height;
  if (!stream || pixels == 0 || pixels > kMostPixels) return fail("has no usable size");
  if (white != 255) return fail("must have shades from 0 to 255");
  picture.pixels.resize(static_cast<std::size_t>(pixels));
  stream.read(reinterpret_cast<char*>(picture.pixels.data()), pixels);
  if (stream.gcount() != pixels) return fail("ends too early");
  return picture;
}

}  // namespace coppice::robot::mapping
