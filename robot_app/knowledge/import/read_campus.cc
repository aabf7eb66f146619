#include "robot_app/knowledge/import/read_campus.h"

#include <algorithm>
#include <filesystem>

#include "robot_app/knowledge/import/gtfs_feed.h"
#include "robot_app/knowledge/import/menu_files.h"
#include "robot_app/knowledge/import/site_files.h"

namespace coppice::robot::knowledge {
namespace {

namespace fs = std::filesystem;

// Also tells of what nobody would read.
std::vector<std::string> FeedsIn(const fs::path& folder, Diagnostics& diagnostics) {
  std::vector<std::string> feeds;
  if (!fs::is_directory(folder)) return feeds;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".zip") {
      feeds.push_back(entry.path());
    } else {
      diagnostics.Error({entry.path(), 0, 0}, "expected a timetable as a .zip");
    }
  }
  std::sort(feeds.begin(), feeds.end());
  return feeds;
}

void ReportOthers(const fs::path& folder, Diagnostics& diagnostics) {
  const std::vector<std::string> known = {"places.yaml",     "campus.yaml", "staff.csv",
                                          "small_talk.yaml", "menus",       "transport"};
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    diagnostics.Warning({entry.path(), 0, 0}, "nobody reads this file", DidYouMean(name, known));
  }
}

}  // namespace

Campus ReadCampus(const std::string& folder, Diagnostics& diagnostics) {
  Campus campus;
  SiteIds ids;
  const fs::path path(folder);
  std::error_code error;
  if (!fs::is_directory(path, error)) {
    diagnostics.Error({folder, 0, 0}, "expected a folder with places.yaml and campus.yaml");
    return campus;
  }
  try {
    ReportOthers(path, diagnostics);
    ReadPlaces(path, campus, ids, diagnostics);
    if (fs::exists(path / "staff.csv")) ReadStaff(path / "staff.csv", campus, ids, diagnostics);
    if (fs::exists(path / "small_talk.yaml")) {
      ReadSmallTalk(path / "small_talk.yaml", campus, diagnostics);
    }
    if (fs::is_directory(path / "menus")) ReadMenus(path / "menus", campus, ids, diagnostics);
    ReadFeeds(FeedsIn(path / "transport", diagnostics), campus, ids, diagnostics);
  } catch (const fs::filesystem_error& problem) {
    diagnostics.Error({folder, 0, 0}, problem.what());
  }
  return campus;
}

}  // namespace coppice::robot::knowledge
