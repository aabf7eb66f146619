#include "robot_app/slam/map/slam_map_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "robot_app/slam/map/map_bytes.h"
#include "tests/robot_app/slam/map/small_map.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::slam {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SlamMapFileTest : public testing::Test {
 protected:
  std::string File(int version) const {
    return folder_.Path("maps/map-00000" + std::to_string(version) + ".slam");
  }
  TemporaryFolder folder_;
  const std::string maps_ = folder_.Path("maps");
};

TEST_F(SlamMapFileTest, ASessionThatHadSeenNothingIsForgotten) {
  SlamMap map = SmallMap();
  map.names.push_back({"wednesday", 0});
  ASSERT_EQ(ParseSlamMap(BytesOf(map))->names.size(), 2u);
  EXPECT_TRUE(ParseSlamMap(BytesOf({{}, {}, {}, map.names}))->names.empty());
}

TEST_F(SlamMapFileTest, SessionsFollowEachOther) {
  SlamMap map = SmallMap();
  map.names.resize(10);
  for (const std::uint32_t second : {2U, 9U, 10U}) {
    map.sessions = {0, 0, 1, second};
    EXPECT_EQ(ParseSlamMap(BytesOf(map)).has_value(), second == 2) << second;
  }
  map.sessions = {1, 1, 1, 1};
  EXPECT_FALSE(ParseSlamMap(BytesOf(map)));
}

TEST_F(SlamMapFileTest, WhatWasSavedIsReadAsItWas) {
  ASSERT_TRUE(SaveSlamMap(maps_, SmallMap()));
  const auto loaded = LoadSlamMap(maps_);
  ASSERT_TRUE(loaded) << loaded.problem();
  const SlamMap& map = loaded->map;
  EXPECT_EQ(loaded->version, 1);
  EXPECT_EQ(map.names[1].name, "tuesday");
  EXPECT_EQ(map.sessions, SmallMap().sessions);
  EXPECT_TRUE(map.graph.poses[3].isApprox(SmallMap().graph.poses[3]));
  EXPECT_EQ(map.graph.links[1].kind, LinkKind::kCloud);
  EXPECT_TRUE(map.graph.links[1].relative.isApprox(SmallMap().graph.poses[3]));
  const KeyFrame& key_frame = *map.key_frames[2];
  EXPECT_EQ(key_frame.stamp, 20);
  ASSERT_TRUE(key_frame.place.has_value());
  EXPECT_EQ(key_frame.place->y, -1.5);
  EXPECT_FALSE(map.key_frames[1]->place.has_value());
  EXPECT_TRUE(key_frame.points[1].isApprox(Eigen::Vector3f(-3.25F, 0, 1)));
  ASSERT_EQ(key_frame.camera_clouds.size(), 1U);
  EXPECT_TRUE(key_frame.camera_clouds[0].camera.isApprox(Eigen::Vector3f(0.25F, 0, 1.5F)));
  EXPECT_TRUE(key_frame.camera_clouds[0].points[1].isApprox(Eigen::Vector3f(2, -1, 0.5F)));
  EXPECT_EQ(key_frame.descriptor.contour[7], 4.5F);
  EXPECT_EQ(key_frame.pictures[0]->descriptors[0][3], 2U);
  EXPECT_TRUE(std::isnan(key_frame.pictures[0]->points[0].x()));
}

// More bytes than any vector of the robot's programs may have.
TEST_F(SlamMapFileTest, AMapOfKilometresIsSavedAndRead) {
  SlamMap map = SmallMap();
  auto key_frame = std::make_shared<KeyFrame>(*map.key_frames[0]);
  std::uint32_t random = 1;
  const auto next = [&] {
    return static_cast<float>((random = random * 1664525 + 1013904223) >> 20);
  };
  for (int i = 0; i < 500'000; ++i) {
    key_frame->points.emplace_back(next() / 20, next() / 20, next() / 20);
  }
  constexpr std::size_t kFrames = 27;
  map.key_frames.assign(kFrames, key_frame);
  map.sessions.assign(kFrames, 0);
  map.names.resize(1);
  map.graph.poses.assign(kFrames, map.graph.poses[1]);
  ASSERT_TRUE(SaveSlamMap(maps_, map));
  const auto loaded = LoadSlamMap(maps_);
  ASSERT_TRUE(loaded) << loaded.problem();
  EXPECT_EQ(loaded->map.key_frames.size(), kFrames);
  EXPECT_EQ(loaded->map.key_frames.back()->points.size(), key_frame->points.size());
}

TEST_F(SlamMapFileTest, KeyFramesThatAreNotInMemoryAreAskedFor) {
  SlamMap map = SmallMap();
  map.key_frames[2].reset();
  const auto packed = [](std::uint32_t key_frame) -> Expected<std::string> {
    if (key_frame != 2) return Problem{"only the third one was asked for"};
    Writer writer;
    PutKeyFrame(*SmallMap().key_frames[2], writer);
    return std::string(std::string_view(Packed(writer.bytes())));
  };
  ASSERT_TRUE(SaveSlamMap(maps_, map, packed));
  const auto loaded = LoadSlamMap(maps_);
  ASSERT_TRUE(loaded) << loaded.problem();
  EXPECT_EQ(loaded->map.key_frames[2]->stamp, 20);
  const auto missing = SaveSlamMap(
      maps_, map, [](std::uint32_t) -> Expected<std::string> { return Problem{"it is gone"}; });
  EXPECT_EQ(missing.problem(), "it is gone");
  EXPECT_EQ(NewestVersion(maps_), 1);
}

TEST_F(SlamMapFileTest, TheThreeNewestVersionsStay) {
  for (int i = 1; i <= 5; ++i) ASSERT_EQ(*SaveSlamMap(maps_, SmallMap()), i);
  EXPECT_FALSE(fs::exists(File(2)));
  EXPECT_TRUE(fs::exists(File(3)));
  EXPECT_EQ(LoadSlamMap(maps_)->version, 5);
}

TEST_F(SlamMapFileTest, ALinkOrAPipeInItsPlaceIsNotWrittenThrough) {
  fs::create_directories(maps_);
  fs::create_symlink(folder_.Path("other"), File(1) + ".new");
  ASSERT_EQ(mkfifo((File(2) + ".new").c_str(), 0600), 0);
  EXPECT_EQ(*SaveSlamMap(maps_, SmallMap()), 1);
  EXPECT_EQ(*SaveSlamMap(maps_, SmallMap()), 2);
  EXPECT_FALSE(fs::exists(folder_.Path("other")));
  EXPECT_EQ(LoadSlamMap(maps_)->version, 2);
}

TEST_F(SlamMapFileTest, ANumberThatNoMapHasIsNoVersion) {
  fs::create_directories(maps_);
  std::ofstream(folder_.Path("maps/map-2147483647.slam")) << "x";
  EXPECT_EQ(*SaveSlamMap(maps_, SmallMap()), 1);
  EXPECT_EQ(LoadSlamMap(maps_)->version, 1);
}

TEST_F(SlamMapFileTest, ADamagedVersionIsSaidAndTheOneBeforeItIsRead) {
  ASSERT_TRUE(SaveSlamMap(maps_, SmallMap()));
  ASSERT_TRUE(SaveSlamMap(maps_, SmallMap()));
  std::string bytes = ReadFile(File(2));
  bytes[bytes.size() / 2] ^= 0x10;
  WriteFile(File(2), bytes);
  const auto loaded = LoadSlamMap(maps_);
  ASSERT_TRUE(loaded) << loaded.problem();
  EXPECT_EQ(loaded->version, 1);
  EXPECT_THAT(loaded->remark, HasSubstr("map-000002.slam: the map is damaged"));
}

TEST_F(SlamMapFileTest, WhateverIsCutOffIsAProblem) {
  ASSERT_TRUE(SaveSlamMap(maps_, SmallMap()));
  const std::string bytes = ReadFile(File(1));
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    WriteFile(folder_.Path("cut"), bytes.substr(0, size));
    EXPECT_FALSE(ReadSlamMap(folder_.Path("cut"))) << size;
  }
}

TEST_F(SlamMapFileTest, AFolderWithoutMapsSaysWhatWasExpected) {
  const auto loaded = LoadSlamMap(folder_.Path("nowhere"));
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.problem(), HasSubstr("expected a folder with maps"));
}

}  // namespace
}  // namespace coppice::robot::slam
