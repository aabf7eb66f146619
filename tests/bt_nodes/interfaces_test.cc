// Who includes whom: the robot's adapters know the interfaces that leaves call, never the leaves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "tests/support/folders.h"

namespace coppice::leaves {
namespace {

namespace fs = std::filesystem;
using Files = std::set<std::string>;  // relative to the root of the project

Files FilesIn(const std::string& folder) {
  Files files;
  const fs::path root = SourceFolder();
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string kind = entry.path().extension();
    if (kind == ".h" || kind == ".cc") files.insert(fs::relative(entry.path(), root));
  }
  return files;
}

// What a file includes of the project.
Files IncludesOf(const std::string& file) {
  constexpr std::string_view kInclude = "#include \"";
  Files includes;
  std::ifstream text(SourceFolder() + "/" + file);
  for (std::string line; std::getline(text, line);) {
    if (line.rfind(kInclude, 0) != 0) continue;
    const std::string name = line.substr(kInclude.size());
    includes.insert(name.substr(0, name.find('"')));
  }
  return includes;
}

void Collect(const std::string& file, Files& all) {
  for (const std::string& include : IncludesOf(file)) {
    if (all.insert(include).second) Collect(include, all);
  }
}

Files AllIncludesOf(const std::string& file) {
  Files all;
  Collect(file, all);
  return all;
}

// "bt_nodes/power/way_home.h" lies in the room "power"; empty for what lies in none.
std::string RoomOf(const std::string& file) {
  const std::string below = file.rfind("bt_nodes/", 0) == 0 ? file.substr(9) : "";
  const std::size_t end = below.find('/');
  return end == std::string::npos ? "" : below.substr(0, end);
}

std::map<std::string, Files> RoomsThatRoomsInclude() {
  std::map<std::string, Files> includes;
  for (const std::string& file : FilesIn("bt_nodes")) {
    for (const std::string& include : IncludesOf(file)) {
      const bool leaves = RoomOf(file) != RoomOf(include) && !RoomOf(include).empty();
      if (leaves && !RoomOf(file).empty()) includes[RoomOf(file)].insert(RoomOf(include));
    }
  }
  return includes;
}

TEST(Interfaces, AdaptersOnRosDoNotSeeTheBaseOfTheLeaves) {
  for (const std::string& file : FilesIn("robot_app/ros")) {
    EXPECT_THAT(AllIncludesOf(file), testing::Not(testing::Contains("bt_core/nodes/leaf.h")))
        << file;
  }
}

TEST(Interfaces, WhatALinkBetweenTreesOffersIsNoLeaf) {
  EXPECT_THAT(AllIncludesOf("bt_nodes/application/application_control.h"), testing::IsEmpty());
}

// Rooms are taken away that include only rooms which are gone, until none is left.
TEST(Interfaces, RoomsOfLeavesIncludeOneAnotherInOneDirectionOnly) {
  std::map<std::string, Files> rooms = RoomsThatRoomsInclude();
  const auto find_free = [&] {
    return std::find_if(rooms.begin(), rooms.end(), [&](const auto& room) {
      return std::none_of(room.second.begin(), room.second.end(),
                          [&](const std::string& other) { return rooms.count(other) > 0; });
    });
  };
  for (auto free = find_free(); free != rooms.end(); free = find_free()) rooms.erase(free);
  EXPECT_THAT(rooms, testing::IsEmpty());
}

}  // namespace
}  // namespace coppice::leaves
