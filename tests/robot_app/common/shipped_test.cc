#include "robot_app/common/shipped.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot {
namespace {

struct Installed : testing::Test {
  Installed() {
    std::filesystem::create_directories(folder.Path("bin"));
    std::filesystem::create_directories(share);
  }
  std::string Find(const std::string& built) const {
    return ShippedWith(folder.Path("bin"), built);
  }
  TemporaryFolder folder;
  std::string share = folder.Path("share/coppice/robot");
};

TEST_F(Installed, FindsFilesOfTheSourcesBesideItself) {
  EXPECT_EQ(Find(SourceFolder() + "/robot_app/description/sobi.urdf"),
            share + "/robot_app/description/sobi.urdf");
}

TEST_F(Installed, FollowsStepsUpwardsInAPath) {
  EXPECT_EQ(Find(SourceFolder() + "/robot_app/tablet/../knowledge/language"),
            share + "/robot_app/knowledge/language");
}

TEST_F(Installed, LeavesOtherPathsAsTheyAre) {
  EXPECT_EQ(Find("/etc/robot.yaml"), "/etc/robot.yaml");
}

TEST(Built, FindsFilesWhereTheyWereBuilt) {
  const TemporaryFolder folder;
  const std::string file = SourceFolder() + "/robot_app/description/sobi.urdf";
  EXPECT_EQ(ShippedWith(folder.Path("bin"), file), file);
  EXPECT_EQ(Shipped(file), file);
}

}  // namespace
}  // namespace coppice::robot
