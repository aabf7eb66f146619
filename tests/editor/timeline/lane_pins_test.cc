#include "editor/timeline/lane_pins.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(LanePins, StayInTheOrderInWhichTheyWereSetForEachRun) {
  LanePins pins;
  pins.Toggle("a", "round/drive");
  pins.Toggle("a", "dock");
  pins.Toggle("b", "dock");
  EXPECT_EQ(pins.Of("a"), (std::vector<std::string>{"round/drive", "dock"}));
  EXPECT_TRUE(pins.Has("b", "dock"));
  EXPECT_FALSE(pins.Has("b", "round/drive"));
  pins.Toggle("a", "round/drive");
  EXPECT_EQ(pins.Of("a"), std::vector<std::string>{"dock"});
  pins.Toggle("a", "dock");
  EXPECT_EQ(pins.all().count("a"), 0U) << "a run without pins is not kept";
  EXPECT_TRUE(pins.Of("a").empty());
}

}  // namespace
}  // namespace coppice::editor
