#include "robot_app/mapping/map_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "tests/robot_app/navigation/test_floor.h"
#include "tests/robot_app/processes/temporary.h"

namespace coppice::robot::mapping {
namespace {

using processes::Temporary;

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

OccupancyGrid SmallMap() {
  OccupancyGrid map = navigation::EmptyRoom(3, 2);
  map.frame.origin_x = -1.025;
  map.frame.origin_y = 0.5;
  navigation::Fill(map, {0, 1}, {1, 2}, -1);
  map.cells[0] = 70;
  map.cells[map.frame.width + 1] = 12;
  return map;
}

void Write(const std::string& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::vector<std::string> FilesIn(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().extension().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(MapFile, KeepsPlaceAndCells) {
  const std::string file = Temporary("kept.yaml");
  const OccupancyGrid map = SmallMap();
  Diagnostics diagnostics;
  ASSERT_TRUE(SaveMap(file, map, diagnostics)) << diagnostics.ToString();
  const auto loaded = LoadMap(file, diagnostics);
  ASSERT_TRUE(loaded) << diagnostics.ToString();
  EXPECT_EQ(loaded->frame.width, map.frame.width);
  EXPECT_EQ(loaded->frame.height, map.frame.height);
  EXPECT_NEAR(loaded->frame.origin_x, -1.025, 1e-9);
  EXPECT_NEAR(loaded->frame.origin_y, 0.5, 1e-9);
  EXPECT_DOUBLE_EQ(loaded->frame.resolution, 0.05);
  int wrong = 0;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const int expected = map.cells[i] < 0 ? -1 : map.cells[i] >= 65 ? 100 : 0;
    if (loaded->cells[i] != expected) ++wrong;
  }
  EXPECT_EQ(wrong, 0);
}

TEST(MapFile, ANewMapReplacesTheOldOneAndItsPicture) {
  const std::string folder = Temporary("replaced");
  fs::create_directories(folder);
  Write(folder + "/map-of-me.pgm", "somebody else's");
  Diagnostics diagnostics;
  OccupancyGrid map = SmallMap();
  ASSERT_TRUE(SaveMap(folder + "/map.yaml", map, diagnostics));
  map.cells[500] = 100;
  ASSERT_TRUE(SaveMap(folder + "/map.yaml", map, diagnostics));
  ASSERT_TRUE(SaveMap(folder + "/map.yaml", map, diagnostics));
  EXPECT_THAT(FilesIn(folder), ElementsAre(".pgm", ".pgm", ".yaml"));
  EXPECT_TRUE(fs::exists(folder + "/map-of-me.pgm"));
  const auto loaded = LoadMap(folder + "/map.yaml", diagnostics);
  ASSERT_TRUE(loaded) << diagnostics.ToString();
  EXPECT_EQ(loaded->cells[500], 100);
}

TEST(MapFile, TellsWhyItCannotBeWritten) {
  Diagnostics diagnostics;
  EXPECT_FALSE(SaveMap("/does/not/exist/map.yaml", SmallMap(), diagnostics));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("/does/not/exist"));
}

TEST(MapFile, ReadsWhatMapServerHasWritten) {
  const std::string file = Temporary("foreign.yaml");
  Write(Temporary("foreign.pgm"), "P5\n# CREATOR: map_saver.cpp 0.050 m/pix\n3 2\n255\n" +
                                      std::string("\376\315\0\0\0\376", 6));
  Write(file,
        "image: foreign.pgm\nresolution: 0.050000\norigin: [-100.000000, -51.224998, 0.000000]\n"
        "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n\n");
  Diagnostics diagnostics;
  const auto map = LoadMap(file, diagnostics);
  ASSERT_TRUE(map) << diagnostics.ToString();
  EXPECT_THAT(map->cells, ElementsAre(100, 100, 0, 0, -1, 100));
  EXPECT_NEAR(map->frame.origin_y, -51.225, 1e-5);
}

std::string ProblemsOf(const std::string& yaml, const std::string& picture) {
  const std::string file = Temporary("bad.yaml");
  Write(file, yaml);
  Write(Temporary("bad.pgm"), picture);
  Diagnostics diagnostics;
  EXPECT_FALSE(LoadMap(file, diagnostics)) << yaml;
  return diagnostics.ToString();
}

TEST(MapFile, RefusesADescriptionThatIsWrong) {
  const std::string picture = "P5 1 1 255 x";
  EXPECT_THAT(ProblemsOf("", picture), HasSubstr("bad.yaml"));
  EXPECT_THAT(ProblemsOf("[1, 2", picture), HasSubstr("bad.yaml:1"));
  const std::string all = ProblemsOf(
      "image: bad.pgm\nresolution: -1\norigin: [0, here]\nnegate: 2\noccupied_tresh: 0.6\n",
      picture);
  EXPECT_THAT(all, HasSubstr("bad.yaml:2"));
  EXPECT_THAT(all, HasSubstr("here"));
  EXPECT_THAT(all, HasSubstr("[x, y, yaw]"));
  EXPECT_THAT(all, HasSubstr("negate"));
  EXPECT_THAT(all, HasSubstr("occupied_thresh"));
  EXPECT_THAT(ProblemsOf("image: bad.pgm\nresolution: 0.05\norigin: [0, 0, 0.3]\n", picture),
              HasSubstr("turned"));
  EXPECT_THAT(ProblemsOf("image: bad.pgm\norigin: [0, 0, 0]\n", picture), HasSubstr("resolution"));
  EXPECT_THAT(ProblemsOf("resolution: 0.05\norigin: [0, 0, 0]\n", picture), HasSubstr("image"));
}

TEST(MapFile, RefusesAPictureThatIsNone) {
  const std::string yaml = "image: bad.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n";
  EXPECT_THAT(ProblemsOf(yaml, ""), HasSubstr("no PGM"));
  EXPECT_THAT(ProblemsOf(yaml, "P6 1 1 255 xyz"), HasSubstr("no PGM"));
  EXPECT_THAT(ProblemsOf(yaml, "P5 # and nothing more"), HasSubstr("size"));
  EXPECT_THAT(ProblemsOf(yaml, "P5 -3 4 255 x"), HasSubstr("size"));
  EXPECT_THAT(ProblemsOf(yaml, "P5 99999 99999 255 x"), HasSubstr("size"));
  EXPECT_THAT(ProblemsOf(yaml, "P5 99999999999999999999 1 255 x"), HasSubstr("size"));
  EXPECT_THAT(ProblemsOf(yaml, "P5 2 2 65535 xxxxxxxx"), HasSubstr("shades"));
  EXPECT_THAT(ProblemsOf(yaml, "P5 2 2 255 xyz"), HasSubstr("too early"));
  EXPECT_THAT(ProblemsOf("image: not_there.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n", ""),
              HasSubstr("not_there.pgm"));
}

TEST(MapFile, DoesNotWaitForAPipe) {
  const std::string pipe = Temporary("pipe.pgm");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(ProblemsOf("image: " + pipe + "\nresolution: 0.05\norigin: [0, 0, 0]\n", ""),
              HasSubstr("is a device or a pipe"));
}

}  // namespace
}  // namespace coppice::robot::mapping
