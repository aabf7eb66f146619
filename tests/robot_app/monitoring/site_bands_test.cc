#include "robot_app/monitoring/site_bands.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/support/folders.h"

namespace coppice::robot::monitoring {
namespace {

class SiteBandsTest : public testing::Test {
 protected:
  MonitorConfig Read(const std::string& bands) {
    const std::string folder = SourceFolder() + "/robot_app/config/";
    MonitorConfig config = LoadMonitorConfig(folder + "monitors.yaml", diagnostics_);
    const std::string path = testing::TempDir() + "site_bands_test.yaml";
    std::ofstream(path) << bands;
    ReadSiteBands(path, config, diagnostics_);
    return config;
  }
  std::string Errors() const { return diagnostics_.ToString(); }
  Diagnostics diagnostics_;
};

TEST_F(SiteBandsTest, WhatTheyNameIsJudgedOtherwiseAndAllElseAsBefore) {
  const MonitorConfig before = Read("{}");
  const MonitorConfig after = Read(R"(
navigation: {blocked: 120}
localization: {score: {warn: [0.15, none]}}
map_jump: {warn: [none, 3]}
)");
  EXPECT_EQ(Errors(), "");
  const WatchList& list = after.ForConfiguration("away");
  EXPECT_EQ(list.navigation->blocked, std::chrono::seconds(120));
  EXPECT_EQ(list.navigation->no_path, before.ForConfiguration("away").navigation->no_path);
  EXPECT_EQ(list.localization->score.warn.low, 0.15);
  EXPECT_EQ(list.localization->deviation.warn.high,
            before.ForConfiguration("away").localization->deviation.warn.high);
  EXPECT_EQ(list.transforms[0].jump.warn.high, 3);
  EXPECT_EQ(list.transforms[1].jump.warn.high,
            before.ForConfiguration("away").transforms[1].jump.warn.high);
  EXPECT_FALSE(after.ForConfiguration("safe_stop").navigation);
}

TEST_F(SiteBandsTest, WhileAMapIsMadeNobodyJudgesItsJumps) {
  const MonitorConfig config = Read("map_jump: {warn: [none, 3]}");
  EXPECT_FALSE(config.ForConfiguration("mapping").transforms[0].jump.warn.high);
}

TEST_F(SiteBandsTest, TheWayHomeIsMeasuredToTheHomeOfTheSite) {
  const MonitorConfig config = Read("dock: {places: " + SourceFolder() +
                                    "/robot_app/config/sites/institute_upper/places.yaml}");
  EXPECT_EQ(Errors(), "");
  ASSERT_TRUE(config.ForConfiguration("away").battery->dock);
  EXPECT_EQ(config.ForConfiguration("away").battery->dock->x, 1.6);
}

TEST_F(SiteBandsTest, AWordThatMeansNothingIsToldWithItsPlace) {
  Read("localization: {scor: {warn: [0.1, none]}}");
  EXPECT_THAT(Errors(), testing::HasSubstr(":1:16: error: unknown key \"scor\""));
}

TEST_F(SiteBandsTest, ThoseOfTheShippedSitesAreRight) {
  for (const auto& site :
       std::filesystem::directory_iterator(SourceFolder() + "/robot_app/config/sites")) {
    MonitorConfig config;
    ReadSiteBands(site.path() / "bands.yaml", config, diagnostics_);
    EXPECT_EQ(Errors(), "") << site.path();
  }
}

}  // namespace
}  // namespace coppice::robot::monitoring
