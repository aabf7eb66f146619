#include "robot_app/mapping/map_file.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "bt_core/model/write_file.h"
#include "robot_app/common/yaml_fields.h"
#include "robot_app/mapping/gray_picture.h"

namespace coppice::robot::mapping {
namespace {

namespace fs = std::filesystem;

constexpr double kOccupiedFrom = 0.65;  // map_server's defaults
constexpr double kFreeBelow = 0.196;
constexpr double kFarthest = 1e5;  // m
constexpr std::uint8_t kBlack = 0;
constexpr std::uint8_t kUnknownGray = 205;
constexpr std::uint8_t kAlmostWhite = 254;
constexpr std::int8_t kUnknown = -1;

struct Header {
  std::string image;
  double resolution = 0;
  double origin[3] = {};
  bool negate = false;
  double occupied = kOccupiedFrom;
  double free = kFreeBelow;
};

// Pictures begin at the upper left corner, maps at the lower left one.
int IndexInMap(int pixel, int width, int height) {
  return (height - 1 - pixel / width) * width + pixel % width;
}

GrayPicture Draw(const OccupancyGrid& map) {
  GrayPicture picture{map.frame.width, map.frame.height, {}};
  picture.pixels.resize(map.cells.size());
  for (int i = 0; i < map.frame.size(); ++i) {
    const std::int8_t cell = map.cells[IndexInMap(i, map.frame.width, map.frame.height)];
    picture.pixels[i] = cell < 0                           ? kUnknownGray
                        : cell >= OccupancyGrid::kOccupied ? kBlack
                                                           : kAlmostWhite;
  }
  return picture;
}

// FNV-1a.
std::string NameOfContent(const std::string& text) {
  std::uint32_t hash = 2166136261U;
  for (const char letter : text) hash = (hash ^ static_cast<std::uint8_t>(letter)) * 16777619U;
  char name[9];
  std::snprintf(name, sizeof name, "%08x", hash);
  return name;
}

std::string Describe(const std::string& image, const GridFrame& frame) {
  char text[512];
  std::snprintf(text, sizeof text,
                "image: %s\nresolution: %.6g\norigin: [%.6f, %.6f, 0.0]\nnegate: 0\n"
                "occupied_thresh: %.2f\nfree_thresh: %.3f\n",
                image.c_str(), frame.resolution, frame.origin_x, frame.origin_y, kOccupiedFrom,
                kFreeBelow);
  return text;
}

// Pictures of this map that SaveMap has written and that are not used any more.
void RemoveOthers(const fs::path& yaml, const std::string& image) {
  const std::string begin = yaml.stem().string() + "-";
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fs::absolute(yaml).parent_path(), error)) {
    const std::string name = entry.path().filename().string();
    const bool is_ours =
        name.size() == begin.size() + 12 && name.rfind(begin, 0) == 0 &&
        name.find_first_not_of("0123456789abcdef", begin.size()) == begin.size() + 8 &&
        entry.path().extension() == ".pgm";
    if (is_ours && name != image) fs::remove(entry.path(), error);
  }
}

void ReadOrigin(YamlFields& fields, Header& header) {
  const std::vector<LocatedText> numbers = fields.Texts("origin");
  for (std::size_t i = 0; i < numbers.size() && i < 3; ++i) {
    char* end = nullptr;
    header.origin[i] = std::strtod(numbers[i].text.c_str(), &end);
    if (*end != 0 || !(std::abs(header.origin[i]) <= kFarthest)) {
      fields.Error(numbers[i].where, "\"" + numbers[i].text + "\" is no coordinate");
    }
  }
  if (numbers.size() != 3) fields.Error(fields.where(), "\"origin\" must be [x, y, yaw]");
  if (header.origin[2] != 0) {
    fields.Error(fields.where(), "a map that is turned against its frame cannot be used");
  }
}

Header ReadHeader(const std::string& yaml, Diagnostics& diagnostics) {
  Header header;
  YamlFields fields = YamlFields::Load(yaml, diagnostics);
  if (diagnostics.has_errors()) return header;
  header.image = fields.Text("image").text;
  if (!fields.Has("resolution")) fields.Error(fields.where(), "missing key \"resolution\"");
  header.resolution = fields.Number("resolution", 0.05, 0.001, 10);
  ReadOrigin(fields, header);
  header.negate = fields.Integer("negate", 0, 0, 1) == 1;
  header.occupied = fields.Number("occupied_thresh", kOccupiedFrom, 0, 1);
  header.free = fields.Number("free_thresh", kFreeBelow, 0, 1);
  if (header.free > header.occupied) {
    fields.Error(fields.where(), "\"free_thresh\" is above \"occupied_thresh\"");
  }
  fields.Choice("mode", "trinary", {"trinary"});
  fields.Finish();
  return header;
}

}  // namespace

bool SaveMap(const std::string& yaml, const OccupancyGrid& map, Diagnostics& diagnostics) {
  const fs::path path = yaml;
  const std::string pixels = ToPgm(Draw(map));
  const std::string image = path.stem().string() + "-" + NameOfContent(pixels) + ".pgm";
  if (!WriteFile((path.parent_path() / image).string(), pixels, diagnostics)) return false;
  if (!WriteFile(yaml, Describe(image, map.frame), diagnostics)) return false;
  RemoveOthers(path, image);
  return true;
}

std::optional<OccupancyGrid> LoadMap(const std::string& yaml, Diagnostics& diagnostics) {
  const Header header = ReadHeader(yaml, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  const std::string image = (fs::path(yaml).parent_path() / header.image).string();
  const std::optional<GrayPicture> picture = LoadPgm(image, diagnostics);
  if (!picture) return std::nullopt;
  OccupancyGrid map;
  map.frame = {header.resolution, header.origin[0], header.origin[1], picture->width,
               picture->height};
  map.cells.resize(picture->pixels.size());
  for (int i = 0; i < map.frame.size(); ++i) {
    const double gray = picture->pixels[i] / 255.0;
    const double occupied = header.negate ? gray : 1 - gray;
    map.cells[IndexInMap(i, picture->width, picture->height)] =
        occupied > header.occupied ? std::int8_t{100}
        : occupied < header.free   ? std::int8_t{0}
                                   : kUnknown;
  }
  Expected<OccupancyGrid> fitting = WithRoom(std::move(map));
  if (fitting) return *std::move(fitting);
  diagnostics.Error({yaml, 0, 0}, fitting.problem());
  return std::nullopt;
}

}  // namespace coppice::robot::mapping
