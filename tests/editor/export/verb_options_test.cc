#include "editor/export/verb_options.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

Expected<PictureOrder> Read(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions({"paint", "", {}, "", PictureOptions()}, arguments);
  return ReadPictureOrder(options);
}

TEST(VerbOptions, AreLightAndTopToBottomIfNothingIsSaid) {
  const auto order = Read({});
  ASSERT_TRUE(order) << order.problem();
  EXPECT_EQ(order->path, "");
  EXPECT_EQ(order->painting.palette, PaletteName::kLight);
  EXPECT_TRUE(order->painting.style == LayoutStyle());
}

TEST(VerbOptions, AreReadIntoThePainting) {
  const auto order = Read({"-o", "t.png", "--across", "--compact", "--layered", "--scale", "3",
                           "--palette", "dark", "--models", "a", "--models", "b"});
  ASSERT_TRUE(order) << order.problem();
  EXPECT_EQ(order->path, "t.png");
  EXPECT_EQ(order->pixels, 3);
  EXPECT_EQ(order->models.size(), 2U);
  EXPECT_EQ(order->painting.palette, PaletteName::kDark);
  EXPECT_EQ(order->painting.style.growth, Growth::kAcross);
  EXPECT_TRUE(order->painting.style.compact && order->painting.style.layered);
}

TEST(VerbOptions, NamesWhatWasExpected) {
  EXPECT_NE(Read({"-o", "t.bmp"}).problem().find(".svg"), std::string::npos);
}

}  // namespace
}  // namespace coppice::editor
