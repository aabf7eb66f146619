#include "editor/look/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace coppice::editor {
namespace {

// WCAG 2.1, relative luminance and contrast ratio.
double Luminance(Color color) {
  const auto linear = [&](int shift) {
    const double c = ((color >> shift) & 0xFF) / 255.0;
    return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(0) + 0.7152 * linear(8) + 0.0722 * linear(16);
}
double Contrast(Color a, Color b) {
  const double x = Luminance(a) + 0.05;
  const double y = Luminance(b) + 0.05;
  return x > y ? x / y : y / x;
}

TEST(Palette, KeepsTextReadableOnEverySurface) {
  for (const PaletteName name :
       {PaletteName::kDark, PaletteName::kLight, PaletteName::kColourBlind}) {
    const Palette& p = GetPalette(name);
    for (const Color surface :
         {p.panel, p.header, p.canvas, p.field, p.node_body, p.row_selected}) {
      EXPECT_GT(Contrast(p.text, surface), 7) << ToString(name);
      EXPECT_GT(Contrast(p.text_dim, surface), 4) << ToString(name);
    }
    for (const Shape shape : {Shape::kControl, Shape::kDecorator, Shape::kAction, Shape::kCondition,
                              Shape::kSubTree, Shape::kUnknown}) {
      EXPECT_GT(Contrast(p.text_on_header, p.Of(shape)), 4.5) << ToString(name);
    }
    for (const Status status : {Status::kRunning, Status::kSuccess, Status::kFailure}) {
      EXPECT_GT(Contrast(p.Of(status), p.canvas), 2.5) << ToString(name) << ToString(status);
    }
  }
}

TEST(Palette, UsesTheColoursOfOkabeAndItoForTheColourBlind) {
  const Palette& p = GetPalette(PaletteName::kColourBlind);
  EXPECT_EQ(p.running, 0xFF009FE6U);  // #E69F00
  EXPECT_EQ(p.success, 0xFF739E00U);  // #009E73
  EXPECT_EQ(p.failure, 0xFF005ED5U);  // #D55E00
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
