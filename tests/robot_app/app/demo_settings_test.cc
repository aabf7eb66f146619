#include "robot_app/app/demo_settings.h"

#include <gtest/gtest.h>

namespace coppice::robot {
namespace {

TEST(DemoSettings, HaveDefaultsForEverything) {
  const auto settings = ReadDemoSettings({});
  ASSERT_FALSE(settings.exit);
  EXPECT_EQ(settings.rounds, "2");
  EXPECT_TRUE(settings.editor);
  EXPECT_TRUE(settings.folder.is_absolute());
  EXPECT_TRUE(std::filesystem::exists(settings.source / "trees"));
}

TEST(DemoSettings, TakeWhatIsGiven) {
  const auto settings = ReadDemoSettings({"--rounds", "5", "--no-editor", "--run", "/tmp/here"});
  ASSERT_FALSE(settings.exit);
  EXPECT_EQ(settings.rounds, "5");
  EXPECT_FALSE(settings.editor);
  EXPECT_EQ(settings.folder, "/tmp/here");
}

TEST(DemoSettings, RefuseWhatTheyDoNotKnow) { EXPECT_EQ(ReadDemoSettings({"--fast"}).exit, 2); }

}  // namespace
}  // namespace coppice::robot
