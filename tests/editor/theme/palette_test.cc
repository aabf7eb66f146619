#include "editor/theme/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "editor/theme/contrast.h"

namespace coppice::editor {
namespace {

constexpr PaletteName kAll[] = {PaletteName::kDark, PaletteName::kLight, PaletteName::kColourBlind};
constexpr Status kShown[] = {Status::kRunning, Status::kSuccess, Status::kFailure,
                             Status::kSkipped};

std::vector<Color> SurfacesOf(const Palette& p) {
  return {p.panel, p.header, p.canvas, p.field, p.node_body, p.row_hover, p.row_selected};
}

TEST(Palette, KeepsTextReadableOnEverySurface) {
  for (const PaletteName name : kAll) {
    const Palette& p = GetPalette(name);
    for (const Color surface : SurfacesOf(p)) {
      EXPECT_GT(Contrast(p.text, surface), 7) << ToString(name);
      for (const Color writing : {p.text_dim, p.accent, p.link, p.warning, p.error, p.simulation}) {
        EXPECT_GE(Contrast(writing, surface), kReadable)
            << ToString(name) << std::hex << " " << writing << " on " << surface;
      }
      for (const Status status : kShown) {
        EXPECT_GE(Contrast(p.TextOf(status), surface), kReadable)
            << ToString(name) << ToString(status);
      }
    }
    for (const Shape shape : {Shape::kControl, Shape::kDecorator, Shape::kAction, Shape::kCondition,
                              Shape::kSubTree, Shape::kUnknown}) {
      EXPECT_GE(Contrast(p.text_on_header, p.Of(shape)), kReadable) << ToString(name);
    }
    EXPECT_GE(Contrast(p.note_text, p.note), kReadable) << ToString(name);
    EXPECT_GE(Contrast(p.chip_text, p.chip), kReadable) << ToString(name);
  }
}

TEST(Palette, KeysAreReadableInPanelsAndNodes) {
  for (const PaletteName name : kAll) {
    const Palette& p = GetPalette(name);
    for (char c = 'a'; c <= 'z'; ++c) {
      const Color key = p.OfKey(std::string(1, c));
      for (const Color surface : {p.panel, p.field, p.node_body, p.row_hover, p.row_selected}) {
        EXPECT_GE(Contrast(key, surface), kReadable) << ToString(name) << c;
      }
    }
  }
}

TEST(Palette, GraphicsThatTellSomethingAreVisible) {
  for (const PaletteName name : kAll) {
    const Palette& p = GetPalette(name);
    for (const Color surface : {p.canvas, p.panel, p.node_body}) {
      for (const Status status : kShown) {
        EXPECT_GE(Contrast(p.Of(status), surface), kVisible) << ToString(name) << ToString(status);
      }
      EXPECT_GE(Contrast(p.halted, surface), kVisible) << ToString(name);
    }
    EXPECT_GE(Contrast(p.edge, p.canvas), kVisible) << ToString(name);
    EXPECT_GE(Contrast(p.node_border, p.canvas), kVisible) << ToString(name);
  }
}

TEST(Palette, StatusesOfTheColourBlindPaletteAreToldApartByEverybody) {
  const Palette& p = GetPalette(PaletteName::kColourBlind);
  for (const Vision vision : {Vision::kNormal, Vision::kProtanopia, Vision::kDeuteranopia}) {
    for (const Status a : kShown) {
      for (const Status b : kShown) {
        if (a < b) {
          EXPECT_GE(Difference(p.Of(a), p.Of(b), vision), 15) << ToString(a) << ToString(b);
        }
      }
    }
    EXPECT_GE(Difference(p.success, p.failure, vision), 35);
  }
}

TEST(Palette, UsesTheColoursOfOkabeAndItoForTheColourBlind) {
  const Palette& p = GetPalette(PaletteName::kColourBlind);
  EXPECT_EQ(p.running, 0xFF009FE6U);  // #E69F00
  EXPECT_EQ(p.success, 0xFF739E00U);  // #009E73
  EXPECT_EQ(p.failure, 0xFF005ED5U);  // #D55E00
}

// 0 to 360; red is 0, amber 40.
double HueOf(Color color) {
  const double red = color & 0xFFU, green = color >> 8 & 0xFFU, blue = color >> 16 & 0xFFU;
  const double most = std::max({red, green, blue});
  const double span = most - std::min({red, green, blue});
  if (span == 0) return 0;
  const double sixth = most == red     ? (green - blue) / span
                       : most == green ? 2 + (blue - red) / span
                                       : 4 + (red - green) / span;
  return std::fmod(60 * sixth + 360, 360);
}

TEST(Palette, AmberIsWhatRunsAndNoKey) {
  for (const PaletteName name : kAll) {
    const Palette& p = GetPalette(name);
    for (int i = 0; i < 100; ++i) {
      const Color key = p.OfKey(std::to_string(i));
      EXPECT_GT(std::abs(HueOf(key) - HueOf(p.running)), 20) << ToString(name) << std::hex << key;
    }
  }
}

TEST(Palette, GivesAKeyAlwaysTheSameColourAndKeysDifferentOnes) {
  const Palette& p = GetPalette(PaletteName::kDark);
  EXPECT_EQ(p.OfKey("goal"), p.OfKey("goal"));
  std::set<Color> colors;
  for (const char* key : {"goal", "waypoint", "battery_level", "charging", "stops", "rounds",
                          "distance", "pose", "speed", "door"}) {
    colors.insert(p.OfKey(key));
  }
  EXPECT_GE(colors.size(), 4U);
}

TEST(Palette, IsFoundByName) {
  EXPECT_EQ(PaletteFromString("light"), PaletteName::kLight);
  EXPECT_FALSE(PaletteFromString("pink"));
}

TEST(Palette, MixesAndFades) {
  EXPECT_EQ(Mix(0xFF000000, 0xFF0000FF, 0.5F), 0xFF000080U);
  EXPECT_EQ(Fade(0xFF112233, 0.5F), 0x80112233U);
}

}  // namespace
}  // namespace coppice::editor
