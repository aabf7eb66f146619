#include "robot_app/assistance/page/page_texts.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

namespace coppice::robot::assistance {
namespace {

using nlohmann::json;

TEST(HealthText, TellsTheWorstFirst) {
  coppice_msgs::Health health;
  health.entries.resize(3);
  health.entries[0].level = coppice_msgs::HealthEntry::OK;
  health.entries[1].level = coppice_msgs::HealthEntry::STALE;
  health.entries[2].level = coppice_msgs::HealthEntry::ERROR;
  health.entries[2].message = "broken \xff";
  const json entries = json::parse(HealthText(health)).at("entries");
  EXPECT_EQ(entries[0].at("level"), "error");
  EXPECT_EQ(entries[1].at("level"), "stale");
  EXPECT_EQ(entries[2].at("level"), "ok");
}

TEST(ProcessesText, CollectsProcessesByGroup) {
  coppice_msgs::ProcessStates states;
  states.configuration = "operating";
  states.processes.resize(3);
  states.processes[0].name = "lidar";
  states.processes[0].group = "hardware";
  states.processes[1].name = "base";
  states.processes[1].group = "hardware";
  states.processes[2].name = "alone";
  const json groups = json::parse(ProcessesText(states)).at("groups");
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].at("name"), "alone");
  EXPECT_EQ(groups[1].at("processes").size(), 2u);
}

TEST(PlaceText, ThinsTheScanOut) {
  const std::vector<Point2D> scan(541, {1.2345, -2});
  const json place = json::parse(PlaceText(Pose2D{1, 2, 3}, scan));
  EXPECT_EQ(place.at("pose"), json({1.0, 2.0, 3.0}));
  EXPECT_LE(place.at("scan").size(), 400u);
  EXPECT_EQ(place.at("scan")[0], 1.23);
  EXPECT_TRUE(json::parse(PlaceText(std::nullopt, {})).at("pose").is_null());
}

TEST(TreesText, NamesWhatRuns) {
  const json trees = json::parse(TreesText({{"application", true, {"Patrol", "Drive"}}}));
  EXPECT_EQ(trees.at("trees")[0].at("path"), json({"Patrol", "Drive"}));
}

class Map : public testing::Test {
 protected:
  Map() {
    map_.info.width = 2;
    map_.info.height = 3;
    map_.info.resolution = 0.05f;
    map_.info.origin.position.x = -1;
    map_.info.origin.orientation.w = 1;
    map_.data = {0, 100, -1, 0, 0, 0};
  }
  nav_msgs::OccupancyGrid map_;
};

TEST_F(Map, IsAHeaderAndItsCells) {
  const std::optional<std::string> bytes = MapBytes(map_);
  ASSERT_TRUE(bytes);
  ASSERT_EQ(bytes->size(), 28u + 6);
  std::int32_t width = 0;
  float x = 0;
  std::memcpy(&width, bytes->data() + 4, sizeof(width));
  std::memcpy(&x, bytes->data() + 16, sizeof(x));
  EXPECT_EQ(bytes->at(0), 2);
  EXPECT_EQ(width, 2);
  EXPECT_EQ(x, -1);
  EXPECT_EQ(bytes->at(29), 100);
}

TEST_F(Map, ThatContradictsItselfIsNothing) {
  map_.info.width = 1u << 31;
  EXPECT_FALSE(MapBytes(map_));
  map_.info.width = 2;
  map_.info.resolution = 0;
  EXPECT_FALSE(MapBytes(map_));
  map_ = {};
  EXPECT_FALSE(MapBytes(map_));
}

}  // namespace
}  // namespace coppice::robot::assistance
