#include "robot_app/common/robot_description.h"

#include <gmock/gmock.h>

#include <fstream>

#include "robot_app/common/footprint.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot {
namespace {

using testing::HasSubstr;

class RobotDescriptionTest : public testing::Test {
 protected:
  static RobotDescription Sobi() {
    return RobotDescription::Load(SourceFolder() + "/robot_app/description/sobi.urdf").value();
  }
  std::string Write(const std::string& text) {
    const std::string file = folder_.path() + "/robot.urdf";
    std::ofstream(file) << text;
    return file;
  }
  TemporaryFolder folder_;
};

constexpr char kBody[] =
    "<robot name='r'><link name='base_link'><collision><geometry>"
    "<cylinder radius='0.2' length='1'/></geometry></collision></link>";

TEST_F(RobotDescriptionTest, TheShippedRobotIsAsThePaperSaysAndAsTheProgramsTakeItFor) {
  const RobotDescription sobi = Sobi();
  EXPECT_DOUBLE_EQ(sobi.radius(), kRobotRadius);
  EXPECT_DOUBLE_EQ(2 * sobi.radius(), 0.66);
  EXPECT_DOUBLE_EQ(sobi.height(), 1.56);
  EXPECT_DOUBLE_EQ(sobi.wheel_diameter(), 0.26);
  EXPECT_DOUBLE_EQ(sobi.track(), 0.56);
}

TEST_F(RobotDescriptionTest, AMountIsInBaseLinkThroughAllThatIsBetween) {
  const RobotDescription sobi = Sobi();
  const Expected<Mount> front = sobi.MountOf("camera_front");
  ASSERT_TRUE(front) << front.problem();
  EXPECT_DOUBLE_EQ(front->pose.x, 0.17);
  EXPECT_DOUBLE_EQ(front->pose.yaw, 0);
  EXPECT_DOUBLE_EQ(front->height, 1.35);
  const Expected<Mount> rear = sobi.MountOf("camera_rear");
  ASSERT_TRUE(rear) << rear.problem();
  EXPECT_NEAR(rear->pose.x, -0.17, 1e-9);
  EXPECT_NEAR(std::abs(rear->pose.yaw), 3.14159265, 1e-6);
}

TEST_F(RobotDescriptionTest, ParentsComeBeforeTheirChildren) {
  std::vector<std::string> seen = {"base_link"};
  const RobotDescription sobi = Sobi();
  for (const FrameOnRobot& frame : sobi.frames()) {
    EXPECT_THAT(seen, testing::Contains(frame.parent)) << frame.name;
    seen.push_back(frame.name);
  }
  EXPECT_GT(seen.size(), 15u);
}

TEST_F(RobotDescriptionTest, AnUnknownFrameIsAProblemWithTheNearestName) {
  EXPECT_THAT(Sobi().MountOf("velodine").problem(), HasSubstr("did you mean \"velodyne\""));
}

TEST_F(RobotDescriptionTest, WhatMovesOrDoesNotStandLevelHasNoMount) {
  EXPECT_THAT(Sobi().MountOf("left_ear").problem(), HasSubstr("moves on \"head\""));
  EXPECT_THAT(Sobi().MountOf("tablet").problem(), HasSubstr("does not stand level on \"torso\""));
}

TEST_F(RobotDescriptionTest, AFileThatIsMissingOrNoDescriptionIsAProblemThatNamesIt) {
  EXPECT_THAT(RobotDescription::Load("/no/robot.urdf").problem(), HasSubstr("/no/robot.urdf"));
  for (const char* const text : {"", "<robot", "<html/>", "<robot name='r'/>"}) {
    const auto robot = RobotDescription::Load(Write(text));
    ASSERT_FALSE(robot) << text;
    EXPECT_THAT(robot.problem(), HasSubstr("robot.urdf:"));
    EXPECT_THAT(robot.problem(), HasSubstr(": no robot description"));
  }
}

// liburdfdom alone ends the program.
TEST_F(RobotDescriptionTest, ElementsWithinElementsWithoutEndAreAProblemAtTheirLine) {
  std::string deep = "<robot name='r'>\n";
  for (int i = 0; i < 200'000; ++i) deep += "<a>";
  EXPECT_THAT(RobotDescription::Load(Write(deep)).problem(), HasSubstr("robot.urdf:2: no robot"));
}

TEST_F(RobotDescriptionTest, AChainOfHundredThousandsOfLinksIsTooLong) {
  std::string chain = kBody;
  std::string parent = "base_link";
  for (int i = 0; i < 200'000; ++i) {
    const std::string link = "l" + std::to_string(i);
    chain += "<link name='" + link + "'/><joint name='j" + link + "' type='fixed'><parent link='" +
             parent + "'/><child link='" + link + "'/></joint>";
    parent = link;
  }
  EXPECT_THAT(RobotDescription::Load(Write(chain + "</robot>")).problem(),
              HasSubstr("is longer than"));
}

TEST_F(RobotDescriptionTest, ABodyWithoutWhatTheProgramsNeedIsAProblemThatSaysWhat) {
  EXPECT_THAT(
      RobotDescription::Load(Write("<robot name='r'><link name='base'/></robot>")).problem(),
      HasSubstr("hang on is \"base\", expected \"base_link\""));
  EXPECT_THAT(
      RobotDescription::Load(Write("<robot name='r'><link name='base_link'/></robot>")).problem(),
      HasSubstr("no collision that is a cylinder"));
  EXPECT_THAT(RobotDescription::Load(Write(std::string(kBody) + "</robot>")).problem(),
              HasSubstr("no left_wheel and right_wheel"));
}

}  // namespace
}  // namespace coppice::robot
