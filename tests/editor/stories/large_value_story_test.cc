#include <gtest/gtest.h>

#include <ctime>

#include "editor/live/values/value_cache.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

// A map of a building, as a robot keeps it.
std::string MapOf(int rooms) {
  std::string text = R"({"name": "ward", "floor": 2, "rooms": [)";
  for (int i = 0; i < rooms; ++i) {
    text += (i > 0 ? "," : "") + std::string(R"([)") + std::to_string(i) + R"(, "room )" +
            std::to_string(i) + R"("])";
  }
  return text + "]}";
}

class LargeValueStory : public testing::Test {
 protected:
  void Show(const std::string& value) {
    ScriptedRobot* const robot = driver_.AddRobot("robot:1", kLiveTree);
    robot->Write("Main", "map", value);
    robot->Tick();
    driver_.Frames(4);
    driver_.Click("blackboard/Main/map");
    driver_.Frames();
  }

  Driver driver_;
};

TEST_F(LargeValueStory, AClickOnAKeyShowsItsRowsAndWhatIsLongIsFolded) {
  Show(MapOf(1200));
  EXPECT_TRUE(driver_.Has("blackboard/value/name"));
  EXPECT_TRUE(driver_.Has("blackboard/value/rooms"));
  EXPECT_FALSE(driver_.Has("blackboard/value/rooms/0"));
  driver_.Picture("large_value_folded");
}

TEST_F(LargeValueStory, AClickOnARowOpensAndFoldsIt) {
  Show(MapOf(1200));
  ASSERT_TRUE(driver_.Click("blackboard/value/rooms"));
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("blackboard/value/rooms/0/1"));
  EXPECT_FALSE(driver_.Has("blackboard/value/rooms/900")) << "out of sight it is not drawn";
  driver_.Picture("large_value_open");
  driver_.Click("blackboard/value/rooms");
  driver_.Frames();
  EXPECT_FALSE(driver_.Has("blackboard/value/rooms/0"));
}

TEST_F(LargeValueStory, WhatIsFoldedStaysSoWhenTheRobotWritesTheKeyAgain) {
  Show(MapOf(3));
  ASSERT_TRUE(driver_.Click("blackboard/value/rooms"));
  driver_.Frames();
  EXPECT_FALSE(driver_.Has("blackboard/value/rooms/0"));
  static_cast<ScriptedRobot&>(driver_.editor.state().workspace.run()->source())
      .Write("Main", "map", MapOf(4));
  driver_.Frames(4);
  EXPECT_TRUE(driver_.Has("blackboard/value/rooms"));
  EXPECT_FALSE(driver_.Has("blackboard/value/rooms/0"));
}

TEST_F(LargeValueStory, TheSearchFindsWithinTheValue) {
  Show(MapOf(1200));
  ASSERT_TRUE(driver_.Click("blackboard/search"));
  driver_.Type("777");
  driver_.Frames(4);
  EXPECT_TRUE(driver_.Has("blackboard/value/rooms/777/1"));
  EXPECT_FALSE(driver_.Has("blackboard/value/rooms/0"));
  driver_.Picture("large_value_found");
}

// Milliseconds of the processor; what else runs on the computer does not count.
double FrameCost(Driver& driver) {
  constexpr int kFrames = 50;
  const std::clock_t begin = std::clock();
  driver.Frames(kFrames);
  return 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / kFrames;
}

TEST_F(LargeValueStory, AValueOfFiveMegabytesIsReadOnceHoweverManyFramesShowIt) {
  Driver other;
  other.AddRobot("robot:1", kLiveTree)->Write("Main", "map", MapOf(30));
  other.Frames(4);
  other.Click("blackboard/Main/map");
  RecordProperty("small_ms", std::to_string(FrameCost(other)));
  Show(MapOf(200'000));
  RecordProperty("large_ms", std::to_string(FrameCost(driver_)));
  EXPECT_EQ(driver_.editor.state().blackboard.values->readings(), 1);
}

TEST_F(LargeValueStory, TextThatOnlyBeginsLikeAListHasNoRows) {
  Show("[kitchen, lab");
  EXPECT_TRUE(driver_.Has("blackboard/Main/map"));
  EXPECT_FALSE(driver_.Has("blackboard/value/0"));
}

}  // namespace
}  // namespace coppice::editor
