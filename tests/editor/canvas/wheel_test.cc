#include "editor/canvas/wheel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace coppice::editor {
namespace {

constexpr WheelTurn kUp{{0, 1}};
constexpr WheelTurn kUpWithCtrl{{0, 1}, true};
constexpr WheelTurn kUpWithShift{{0, 1}, false, true};
constexpr WheelTurn kLeft{{1, 0}};

TEST(WheelOfTheCanvas, PansAndZoomsWithCtrl) {
  EXPECT_GT(MoveOf(kUp, false).pan.y, 0) << "what is above comes down";
  EXPECT_EQ(MoveOf(kUp, false).zoom, 1);
  EXPECT_EQ(MoveOf(kUpWithCtrl, false).pan, Point());
  EXPECT_GT(MoveOf(kUpWithCtrl, false).zoom, 1);
}

TEST(WheelOfTheCanvas, ZoomsAndPansWithCtrlTheOtherWayRound) {
  EXPECT_GT(MoveOf(kUp, true).zoom, 1);
  EXPECT_EQ(MoveOf(kUp, true).pan, Point());
  EXPECT_EQ(MoveOf(kUpWithCtrl, true).zoom, 1);
  EXPECT_GT(MoveOf(kUpWithCtrl, true).pan.y, 0);
}

TEST(WheelOfTheCanvas, ShiftAndTwoFingersGoSidewaysEitherWay) {
  for (const bool wheel_zooms : {false, true}) {
    for (const WheelTurn& turn : {kUpWithShift, kLeft}) {
      const WheelMove move = MoveOf(turn, wheel_zooms);
      EXPECT_GT(move.pan.x, 0);
      EXPECT_EQ(move.pan.y, 0);
      EXPECT_EQ(move.zoom, 1);
    }
  }
}

TEST(WheelOfTheCanvas, ItsHintSaysWhatItDoes) {
  EXPECT_THAT(std::string(WheelHint(true)), testing::StartsWith("The wheel zooms"));
  EXPECT_THAT(std::string(WheelHint(false)), testing::StartsWith("The wheel moves"));
}

}  // namespace
}  // namespace coppice::editor
