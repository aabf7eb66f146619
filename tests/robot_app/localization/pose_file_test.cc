#include "robot_app/localization/pose_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace coppice::robot::localization {
namespace {

TEST(PoseFile, KeepsThePose) {
  const std::string file = testing::TempDir() + "last_pose";
  std::string error;
  ASSERT_TRUE(SavePose(file, {1.5, -2, 3}, error)) << error;
  ASSERT_TRUE(SavePose(file, {2.5, -2, 3.14159}, error)) << error;
  const auto pose = LoadPose(file);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->x, 2.5, 1e-4);
  EXPECT_NEAR(pose->yaw, 3.1416, 1e-4);
  std::filesystem::remove(file);
}

TEST(PoseFile, IsNothingIfItIsNotThere) { EXPECT_FALSE(LoadPose("/does/not/exist")); }

TEST(PoseFile, TellsWhyItCannotBeWritten) {
  std::string error;
  EXPECT_FALSE(SavePose("/does/not/exist", {}, error));
  EXPECT_NE(error.find("/does/not"), std::string::npos) << error;
}

}  // namespace
}  // namespace coppice::robot::localization
