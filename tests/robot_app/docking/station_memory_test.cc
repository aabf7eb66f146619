#include "robot_app/docking/station_memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace coppice::robot::docking {
namespace {

constexpr Pose2D kPrior{-2.4, 0, 3.1416};
constexpr Pose2D kMoved{-2.1, 0.3, 2.9};

class StationMemoryTest : public testing::Test {
 protected:
  StationMemoryTest() { std::filesystem::remove(file_); }
  ~StationMemoryTest() override { std::filesystem::remove(file_); }
  static void LearnAndSave(StationMemory& memory, const Pose2D& station) {
    ASSERT_TRUE(memory.Learn(station));
    ASSERT_TRUE(memory.Save(station));
    memory.HasSaved(station);
  }
  const std::string file_ = testing::TempDir() + "station_" + std::to_string(getpid());
};

TEST_F(StationMemoryTest, AtFirstTheStationIsWhereTheMapOfPlacesSays) {
  EXPECT_EQ(StationMemory(kPrior, file_).station()->x, kPrior.x);
  EXPECT_FALSE(StationMemory(std::nullopt, file_).station());
}

TEST_F(StationMemoryTest, WhatWasLearntIsKnownAfterARestart) {
  StationMemory before(kPrior, file_);
  LearnAndSave(before, kMoved);
  const StationMemory after(kPrior, file_);
  EXPECT_NEAR(after.station()->x, kMoved.x, 1e-4);
  EXPECT_NEAR(after.station()->y, kMoved.y, 1e-4);
  EXPECT_NEAR(after.station()->yaw, kMoved.yaw, 1e-4);
}

TEST_F(StationMemoryTest, WhoHasMovedItFarAndSaidSoIsBelieved) {
  StationMemory before(kPrior, file_);
  LearnAndSave(before, kMoved);
  EXPECT_EQ(StationMemory(Pose2D{4, 0, 0}, file_).station()->x, 4);
}

TEST_F(StationMemoryTest, ABrokenFileDoesNotCount) {
  std::ofstream(file_) << "somewhere\n";
  EXPECT_EQ(StationMemory(kPrior, file_).station()->x, kPrior.x);
}

TEST_F(StationMemoryTest, AStationThatHasNotMovedIsNotWrittenAgain) {
  StationMemory memory(kPrior, file_);
  LearnAndSave(memory, kMoved);
  EXPECT_FALSE(memory.Learn({kMoved.x + 0.005, kMoved.y, kMoved.yaw}));
  EXPECT_TRUE(memory.Learn(kPrior));
}

// The thread that docks does that; the disk may be slow.
TEST_F(StationMemoryTest, ToLearnWritesNothing) {
  StationMemory memory(kPrior, file_);
  EXPECT_TRUE(memory.Learn(kMoved));
  EXPECT_EQ(memory.station()->x, kMoved.x);
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(StationMemoryTest, WithoutAFileItIsForgottenWithTheProgram) {
  StationMemory memory(kPrior, "none");
  EXPECT_FALSE(memory.Learn(kMoved));
  EXPECT_EQ(memory.station()->x, kMoved.x);
  EXPECT_FALSE(std::filesystem::exists("none"));
}

TEST_F(StationMemoryTest, AFileThatCannotBeWrittenIsToldAndItIsKnownNevertheless) {
  StationMemory memory(kPrior, "/nowhere/station");
  EXPECT_TRUE(memory.Learn(kMoved));
  EXPECT_FALSE(memory.Save(kMoved));
  EXPECT_EQ(memory.station()->x, kMoved.x);
  EXPECT_TRUE(memory.Learn(kMoved));  // the next time it may be written
}

}  // namespace
}  // namespace coppice::robot::docking
