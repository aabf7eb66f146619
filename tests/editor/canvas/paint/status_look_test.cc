#include "editor/canvas/paint/status_look.h"

#include <gtest/gtest.h>

#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

using std::chrono::milliseconds;

constexpr Time kThen = Time(std::chrono::seconds(100));
const Palette& kColors = GetPalette(PaletteName::kLight);

TEST(StatusLook, ColoursTheTrailLikeTheLastStatus) {
  EXPECT_EQ(StatusColor(kColors, {Status::kIdle, Status::kFailure, Time{}}, 7), kColors.failure);
  EXPECT_EQ(StatusColor(kColors, {Status::kRunning, Status::kIdle, Time{}}, 7), kColors.running);
  EXPECT_EQ(StatusColor(kColors, {}, 7), 7U);
}

TEST(StatusLook, TellsAHaltedNodeFromOneThatEnded) {
  const NodeState halted = {Status::kIdle, Status::kRunning, kThen};
  EXPECT_EQ(StatusColor(kColors, halted, 7), kColors.halted);
  EXPECT_STREQ(StatusGlyph(halted), icon::kStop);
  EXPECT_STREQ(StatusGlyph({Status::kIdle, Status::kSuccess, kThen}), icon::kCheck);
  EXPECT_STREQ(StatusGlyph({Status::kSkipped, Status::kIdle, kThen}), icon::kForward);
}

TEST(StatusLook, FadesAResultToATrailWithinTwoSeconds) {
  const NodeState trail = {Status::kIdle, Status::kSuccess, kThen};
  EXPECT_NEAR(StatusStrength(trail, kThen), 1, 1e-3);
  EXPECT_NEAR(StatusStrength(trail, kThen + milliseconds(1000)), 0.725, 1e-3);
  EXPECT_NEAR(StatusStrength(trail, kThen + milliseconds(5000)), 0.45, 1e-3);
  EXPECT_EQ(StatusStrength({Status::kRunning, Status::kIdle, kThen}, kThen), 1);
  EXPECT_TRUE(IsFading(trail, kThen + milliseconds(1900)));
  EXPECT_FALSE(IsFading(trail, kThen + milliseconds(2100)));
}

TEST(StatusLook, FlashesForFourTenthsOfASecond) {
  const NodeState fresh = {Status::kSuccess, Status::kIdle, kThen};
  EXPECT_NEAR(FlashStrength(fresh, kThen), 1, 1e-3);
  EXPECT_NEAR(FlashStrength(fresh, kThen + milliseconds(200)), 0.25, 1e-3);
  EXPECT_EQ(FlashStrength(fresh, kThen + milliseconds(400)), 0);
  EXPECT_EQ(FlashStrength({}, kThen), 0) << "nothing is known of when it came";
}

TEST(StatusLook, GetsHotterFromTheBorderColourOn) {
  for (const PaletteName name : {PaletteName::kDark, PaletteName::kLight}) {
    const Palette& palette = GetPalette(name);
    EXPECT_EQ(HeatColor(palette, 0), palette.node_border);
    for (float heat = 0.1F; heat < 1.01F; heat += 0.1F) {
      const Color color = HeatColor(palette, heat);
      EXPECT_NE(color, palette.node_border) << heat;
      // More blue than green: no mixture of greys and amber, which is what runs.
      EXPECT_GT(color >> 16 & 0xFFU, color >> 8 & 0xFFU) << heat;
    }
  }
}

}  // namespace
}  // namespace coppice::editor
