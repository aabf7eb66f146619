// coppice-map: what is in a map of many sessions; paints it and writes the grid that the map server
// reads.
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "bt_core/base/command_line.h"
#include "bt_core/model/utf8.h"
#include "bt_core/model/write_file.h"
#include "robot_app/common/compressed_picture.h"
#include "robot_app/common/limits/largest_allocation.h"
#include "robot_app/mapping/map_file.h"
#include "robot_app/slam/drawing/map_picture.h"
#include "robot_app/slam/map/map_voxels.h"
#include "robot_app/slam/map/navigation_frame.h"
#include "robot_app/slam/map/slam_map_file.h"
#include "robot_app/slam/map/slam_mapper.h"

namespace coppice::robot::slam {
namespace {

constexpr std::size_t kLongestName = 60;  // bytes, of a session

const Command kMap{
    "coppice-map",
    "show a map in three dimensions",
    {"FOLDER|FILE", 1, 1},
    "Prints the sessions of the newest map in FOLDER, or of one version of it, with\n"
    "their key frames and closures. The plan shows the way of each session and what\n"
    "closed its loops, a section how high things are.",
    {CommandOption::Text("--plan", "FILE", "paint it from above (JPEG)"),
     CommandOption::Text("--section", "FILE", "paint an upright section (JPEG)"),
     CommandOption::Text("--cut", "x=M|y=M",
                         "where it is cut, 0.3 m thick; else along the longer side of the map,\n"
                         "where the robot was most"),
     CommandOption::Text("--voxels", "FILE", "write the voxels as OctoMap reads them (.bt)"),
     CommandOption::Text("--grid", "FILE",
                         "write the grid as map servers read it (.yaml), in the frame of the\n"
                         "map that the robot navigated on meanwhile, if it knew its place there"),
     CommandOption::Real("--resolution", "M", 0.02, 1, "of voxels and plan; else 0.1"),
     CommandOption::Whole("--session", "N", 1, 1000000,
                          "show the map in which this session lies; else 1"),
     CommandOption::Whole(
         "--memory", "MIB", 16, 1 << 20,
         "that it may take; else 200, and 12 times what the file takes on the disk")}};

int Fail(const std::string& problem) {
  std::fprintf(stderr, "coppice-map: %s\n", problem.c_str());
  return 1;
}

// Bytes on the disk; a file with holes may be as long as it likes.
std::size_t BytesOnDisk(const std::string& file) {
  constexpr std::size_t kBlock = 512;  // of st_blocks
  struct stat info = {};
  if (stat(file.c_str(), &info) != 0 || !S_ISREG(info.st_mode)) return 0;
  return static_cast<std::size_t>(info.st_blocks) * kBlock;
}

// Bytes of the file, or of the largest one in the folder.
std::size_t LargestIn(const std::string& name) {
  std::size_t largest = BytesOnDisk(name);
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(name, error)) {
    largest = std::max(largest, BytesOnDisk(entry.path()));
  }
  return std::min(largest, std::size_t{4} << 30);
}

Expected<LoadedMap> Load(const std::string& name) {
  if (std::filesystem::is_directory(name)) return LoadSlamMap(name);
  auto map = ReadSlamMap(name);
  if (!map) return Problem{map.problem()};
  return LoadedMap{*std::move(map), 0, ""};
}

struct SessionFigures {
  int key_frames = 0;
  double way = 0;  // [m]
  int by_picture = 0, by_cloud = 0;
};

std::vector<SessionFigures> FiguresOf(const SlamMap& map) {
  std::vector<SessionFigures> figures(map.names.size());
  for (const std::uint32_t session : map.sessions) ++figures[session].key_frames;
  for (const Link& link : map.graph.links) {
    SessionFigures& session = figures[map.sessions[link.to]];
    if (link.kind == LinkKind::kStep) session.way += link.relative.translation().norm();
    session.by_picture += link.kind == LinkKind::kPicture ? 1 : 0;
    session.by_cloud += link.kind == LinkKind::kCloud ? 1 : 0;
  }
  return figures;
}

void Print(const LoadedMap& loaded) {
  const SlamMap& map = loaded.map;
  if (loaded.version > 0) std::printf("version %d\n", loaded.version);
  const SessionGraph graph({}, map.graph, map.sessions);
  const std::vector<SessionFigures> figures = FiguresOf(map);
  std::printf("%-4s %-20s %4s %10s %8s %10s %9s\n", "", "session", "map", "key frames", "way [m]",
              "by picture", "by cloud");
  for (std::uint32_t i = 0; i < figures.size(); ++i) {
    const SessionFigures& one = figures[i];
    const std::string name = PlainText(map.names[i].name, kLongestName);
    std::printf("%-4u %-20s %4u %10d %8.1f %10d %9d\n", i + 1, name.c_str(), graph.map_of(i) + 1,
                one.key_frames, one.way, one.by_picture, one.by_cloud);
  }
}

int WriteGrid(const LoadedMap& loaded, std::uint32_t session, const Options& options) {
  const VoxelMap voxels = VoxelsOf(MovedToNavigationMap(loaded.map), session,
                                   MapperSettings().lidar, options.Real("--resolution", 0.1));
  const OccupancyGrid grid = voxels.Project();
  if (grid.frame.size() == 0) {
    return Fail("there is nothing to write, or it lies too far apart for --resolution");
  }
  Diagnostics diagnostics;
  if (mapping::SaveMap(options.Get("--grid"), grid, diagnostics)) return 0;
  return Fail(diagnostics.ToString());
}

int WritePicture(const std::string& file, const Picture& picture) {
  const auto bytes = EncodeJpeg(picture, 90);
  Diagnostics diagnostics;
  if (WriteFile(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, diagnostics)) {
    return 0;
  }
  return Fail(diagnostics.ToString());
}

// "x=3.5" cuts along y. Nothing: it is none.
std::optional<Cut> CutOf(const std::string& text) {
  if (text.size() < 3 || (text[0] != 'x' && text[0] != 'y') || text[1] != '=') return std::nullopt;
  char* end = nullptr;
  Cut cut;
  cut.along_x = text[0] == 'y';
  cut.at = std::strtod(text.c_str() + 2, &end);
  if (*end != '\0' || !std::isfinite(cut.at)) return std::nullopt;
  return cut;
}

// Along the longer side of what the robot travelled, at the median of where it was across.
Cut CutOfTheWay(const SlamMap& map) {
  std::vector<double> x, y;
  for (const Pose3& pose : map.graph.poses) {
    x.push_back(pose.translation().x());
    y.push_back(pose.translation().y());
  }
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  Cut cut;
  if (x.empty()) return cut;
  cut.along_x = x.back() - x.front() >= y.back() - y.front();
  const std::vector<double>& across = cut.along_x ? y : x;
  cut.at = across[across.size() / 2];
  return cut;
}

int WriteSection(const LoadedMap& loaded, const VoxelMap& voxels, const Options& options) {
  const auto cut =
      options.Has("--cut") ? CutOf(options.Get("--cut")) : std::optional(CutOfTheWay(loaded.map));
  if (!cut) return Fail("--cut: expected x=M or y=M, not \"" + options.Get("--cut") + "\"");
  const OccupancyGrid section = voxels.Section(*cut);
  if (section.frame.size() == 0) {
    return Fail("nothing is known there, or it lies too far apart for --resolution");
  }
  char name[60];
  std::snprintf(name, sizeof name, "along %c [m] at %c = %.1f m", cut->along_x ? 'x' : 'y',
                cut->along_x ? 'y' : 'x', cut->at);
  return WritePicture(options.Get("--section"), DrawSection(section, name));
}

int WriteWhatIsAsked(const LoadedMap& loaded, const Options& options) {
  const auto session = static_cast<std::uint32_t>(options.Whole("--session", 1) - 1);
  if (session >= loaded.map.names.size()) {
    return Fail("there is no session " + std::to_string(session + 1) + "; the map has " +
                std::to_string(loaded.map.names.size()));
  }
  if (options.Has("--grid")) {
    const int status = WriteGrid(loaded, session, options);
    if (status != 0) return status;
  }
  if (!options.Has("--plan") && !options.Has("--voxels") && !options.Has("--section")) return 0;
  const VoxelMap voxels =
      VoxelsOf(loaded.map, session, MapperSettings().lidar, options.Real("--resolution", 0.1));
  if (options.Has("--voxels")) {
    const Outcome saved = voxels.Save(options.Get("--voxels"));
    if (!saved) return Fail(saved.problem());
  }
  if (options.Has("--section")) {
    const int status = WriteSection(loaded, voxels, options);
    if (status != 0) return status;
  }
  if (!options.Has("--plan")) return 0;
  const OccupancyGrid grid = voxels.Project();
  if (grid.frame.size() == 0) {
    return Fail("there is nothing to paint, or it lies too far apart for --resolution");
  }
  return WritePicture(options.Get("--plan"), DrawPlan(grid, loaded.map, session));
}

int Show(const Options& options) {
  const auto loaded = Load(options.files[0]);
  if (!loaded) return Fail(loaded.problem());
  if (!loaded->remark.empty()) {
    std::fprintf(stderr, "coppice-map: %s; an older version is shown\n", loaded->remark.c_str());
  }
  Print(*loaded);
  return WriteWhatIsAsked(*loaded, options);
}

// A small file may claim to be a large map.
std::size_t MemoryFor(const Options& options) {
  constexpr std::size_t kMegabyte = std::size_t{1} << 20;
  if (options.Has("--memory")) {
    return static_cast<std::size_t>(options.Whole("--memory", 0)) * kMegabyte;
  }
  return 200 * kMegabyte + 12 * LargestIn(options.files[0]);
}

int Main(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(kMap, arguments);
  if (options.exit) return *options.exit;
  LimitMemory(MemoryFor(options));
  try {
    return Show(options);
  } catch (const std::bad_alloc&) {
    return Fail("the map takes more memory than --memory says");
  } catch (const std::exception& error) {
    return Fail(error.what());
  }
}

}  // namespace
}  // namespace coppice::robot::slam

int main(int argc, char** argv) { return coppice::robot::slam::Main({argv + 1, argv + argc}); }
