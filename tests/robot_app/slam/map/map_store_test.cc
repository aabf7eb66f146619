#include "robot_app/slam/map/map_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "tests/robot_app/slam/map/small_map.h"
#include "tests/support/full_disk.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::slam {
namespace {

using testing::HasSubstr;

class MapStoreTest : public testing::Test {
 protected:
  std::unique_ptr<MapStore> Open() const { return *MapStore::Open(file_); }
  static SessionGraph GraphOf(const SlamMap& map) { return {{}, map.graph, map.sessions}; }

  TemporaryFolder folder_;
  const std::string file_ = folder_.Path("memory.db");
  const SlamMap map_ = SmallMap();
};

TEST_F(MapStoreTest, WhatWasKeptIsThereAgain) {
  ASSERT_TRUE(Open()->Keep(map_.names, GraphOf(map_), map_.key_frames));
  const auto store = Open();
  const auto map = store->Load();
  ASSERT_TRUE(map) << map.problem();
  EXPECT_EQ(map->names[1].name, "tuesday");
  EXPECT_EQ(map->sessions, map_.sessions);
  EXPECT_TRUE(map->graph.poses[3].isApprox(map_.graph.poses[3]));
  EXPECT_EQ(map->graph.links.size(), 2U);
  EXPECT_EQ(map->graph.links[1].kind, LinkKind::kCloud);
  EXPECT_EQ(map->key_frames[2], nullptr);
  EXPECT_EQ(store->key_frames(), 4U);
  const auto seen = store->Read(2);
  ASSERT_TRUE(seen) << seen.problem();
  EXPECT_EQ((*seen)->stamp, 20);
  EXPECT_EQ((*seen)->pictures[0]->descriptors[0][3], 2U);
}

TEST_F(MapStoreTest, AKeyFrameIsWrittenAnewWhenItsPlaceHasBecomeKnown) {
  const auto store = Open();
  ASSERT_TRUE(store->Keep(map_.names, GraphOf(map_), map_.key_frames));
  EXPECT_FALSE((*store->Read(1))->place.has_value());
  KeyFrame placed = *map_.key_frames[1];
  placed.place = Pose2D{1, 2, 0.5};
  ASSERT_TRUE(store->Replace(1, placed));
  const auto read = store->Read(1);
  ASSERT_TRUE(read) << read.problem();
  ASSERT_TRUE((*read)->place.has_value());
  EXPECT_EQ((*read)->place->y, 2);
  EXPECT_EQ((*read)->stamp, 10);
}

TEST_F(MapStoreTest, ANewOneIsEmpty) {
  const auto store = Open();
  EXPECT_TRUE(store->Load()->key_frames.empty());
  EXPECT_EQ(store->version(), 0);
  EXPECT_THAT(store->Read(0).problem(), HasSubstr("key frame 0 is missing"));
}

TEST_F(MapStoreTest, PosesThatHaveMovedAndWhatIsNewAreKept) {
  const auto store = Open();
  std::vector<std::shared_ptr<const KeyFrame>> frames = map_.key_frames;
  std::vector<SessionName> names = map_.names;
  SessionGraph graph = GraphOf(map_);
  ASSERT_TRUE(store->Keep(names, graph, frames));
  names.push_back({"wednesday", 200});
  for (int i = 0; i < 300; ++i) {
    graph.AddPose(Pose3::Identity(), InformationOf(0.1, 0.1));
    frames.push_back(map_.key_frames[0]);
    frames[frames.size() - 2].reset();  // the one before is kept already
    ASSERT_TRUE(store->Keep(names, graph, frames));
  }
  PoseGraph moved = graph.graph();
  for (Pose3& pose : moved.poses) pose.translation().x() += 1;
  ASSERT_TRUE(store->Keep(names, {{}, moved, graph.sessions()}, frames));
  const auto map = store->Load();
  ASSERT_TRUE(map) << map.problem();
  EXPECT_EQ(map->key_frames.size(), 304U);
  EXPECT_EQ(map->graph.links.size(), graph.graph().links.size());
  for (std::size_t i = 0; i < 304; ++i) EXPECT_TRUE(map->graph.poses[i].isApprox(moved.poses[i]));
}

TEST_F(MapStoreTest, ItRemembersTheVersionThatWasSaved) {
  ASSERT_TRUE(Open()->SetVersion(7));
  const auto store = Open();
  ASSERT_TRUE(store->Load());
  EXPECT_EQ(store->version(), 7);
  ASSERT_TRUE(store->Clear());
  ASSERT_TRUE(store->Load());
  EXPECT_EQ(store->version(), 0);
}

TEST_F(MapStoreTest, AVersionThatFoundNoRoomIsKeptWithWhatComesNext) {
  {
    const auto store = Open();
    {
      const FullDisk full(0);
      EXPECT_FALSE(store->SetVersion(7));
      EXPECT_FALSE(store->Keep(map_.names, GraphOf(map_), map_.key_frames));
    }
    ASSERT_TRUE(store->Keep(map_.names, GraphOf(map_), map_.key_frames));
  }
  const auto store = Open();
  ASSERT_TRUE(store->Load());
  EXPECT_EQ(store->version(), 7);
  EXPECT_EQ(store->key_frames(), 4U);
}

TEST_F(MapStoreTest, WhatIsDamagedIsPutAsideOrSaid) {
  ASSERT_TRUE(Open()->Keep(map_.names, GraphOf(map_), map_.key_frames));
  std::string bytes = ReadFile(file_);
  int damaged = 0;
  for (std::size_t at = 1000; at < bytes.size(); at += 97) {
    std::string other = bytes;
    for (std::size_t i = at; i < std::min(at + 40, other.size()); ++i) other[i] ^= 0x41;
    WriteFile(file_, other);
    const auto store = Open();
    const auto map = store->Load();
    ASSERT_TRUE(map) << map.problem();
    bool is_whole = map->key_frames.size() == 4;
    for (std::uint32_t i = 0; i < 4; ++i) is_whole = is_whole && store->Read(i).ok();
    damaged += is_whole ? 0 : 1;
  }
  EXPECT_GT(damaged, 5);
}

TEST_F(MapStoreTest, WhatIsNoDatabaseIsPutAside) {
  WriteFile(file_, std::string(5000, 'x'));
  EXPECT_TRUE(Open()->Load()->key_frames.empty());
  EXPECT_TRUE(std::filesystem::exists(file_ + ".damaged"));
}

TEST_F(MapStoreTest, WithoutAFileItIsAsGood) {
  const auto store = *MapStore::Open("");
  ASSERT_TRUE(store->Keep(map_.names, GraphOf(map_), map_.key_frames));
  EXPECT_EQ((*store->Read(3))->stamp, 30);
}

// Each update tells over a pipe that it is kept; whoever is killed then, in whatever it does, has
// lost nothing of what it told.
TEST_F(MapStoreTest, KilledAtAnyMomentItHasAllThatWasKept) {
  int pipe[2];
  ASSERT_EQ(::pipe(pipe), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(pipe[0]);
    const auto store = Open();
    SlamMap map = *store->Load();
    SessionGraph graph = GraphOf(map);
    if (map.names.empty()) map.names = {{"killed", 1}};
    while (true) {
      graph.AddPose(Pose3::Identity(), InformationOf(0.1, 0.1));
      map.key_frames.push_back(SmallMap().key_frames[0]);
      if (!store->Keep(map.names, graph, map.key_frames)) ::_exit(1);
      const auto count = static_cast<std::uint32_t>(map.key_frames.size());
      if (::write(pipe[1], &count, sizeof(count)) != sizeof(count)) ::_exit(2);
    }
  }
  ::close(pipe[1]);
  std::uint32_t kept = 0, last = 0;
  while (kept < 150 && ::read(pipe[0], &last, sizeof(last)) == sizeof(last)) kept = last;
  ::kill(child, SIGKILL);
  while (::read(pipe[0], &last, sizeof(last)) == sizeof(last)) kept = last;
  ::close(pipe[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  const auto store = Open();
  const auto map = store->Load();
  ASSERT_TRUE(map) << map.problem();
  EXPECT_GE(map->key_frames.size(), kept);
  EXPECT_LE(map->key_frames.size(), kept + 1U);
  EXPECT_EQ(map->graph.links.size(), map->key_frames.size() - 1);
  for (std::uint32_t i = 0; i < map->key_frames.size(); ++i) EXPECT_TRUE(store->Read(i)) << i;
}

}  // namespace
}  // namespace coppice::robot::slam
