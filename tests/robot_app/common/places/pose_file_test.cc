#include "robot_app/common/places/pose_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace coppice::robot {
namespace {

TEST(PoseFile, KeepsThePose) {
  const std::string file = testing::TempDir() + "last_pose";
  ASSERT_EQ(SavePose(file, {1.5, -2, 3}).problem(), "");
  ASSERT_EQ(SavePose(file, {2.5, -2, 3.14159}).problem(), "");
  const auto pose = LoadPose(file);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->x, 2.5, 1e-4);
  EXPECT_NEAR(pose->yaw, 3.1416, 1e-4);
  std::filesystem::remove(file);
}

TEST(PoseFile, IsNothingIfItIsNotThere) { EXPECT_FALSE(LoadPose("/does/not/exist")); }

TEST(PoseFile, IsNothingIfItHoldsNone) {
  const std::string file = testing::TempDir() + "no_pose";
  for (const std::string& text : {std::string(5000, ' ') + "1 2 3", std::string("1e300 0 0"),
                                  std::string("1 2"), std::string("nan 0 0"), std::string()}) {
    std::ofstream(file) << text;
    EXPECT_FALSE(LoadPose(file)) << text;
  }
  EXPECT_FALSE(LoadPose("/dev/zero"));
  std::filesystem::remove(file);
}

TEST(PoseFile, TellsWhyItCannotBeWritten) {
  const Outcome saved = SavePose("/does/not/exist", {});
  EXPECT_NE(saved.problem().find("/does/not"), std::string::npos) << saved.problem();
}

}  // namespace
}  // namespace coppice::robot
