#include "editor/export/verb_options.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

std::optional<PictureOrder> Read(const std::vector<std::string>& arguments, std::string& wrong) {
  const Options options = ParseOptions({"paint", "", {}, "", PictureOptions()}, arguments);
  return ReadPictureOrder(options, wrong);
}

TEST(VerbOptions, AreLightAndTopToBottomIfNothingIsSaid) {
  std::string wrong;
  const auto order = Read({}, wrong);
  ASSERT_TRUE(order) << wrong;
  EXPECT_EQ(order->path, "");
  EXPECT_EQ(order->painting.palette, PaletteName::kLight);
  EXPECT_TRUE(order->painting.style == LayoutStyle());
}

TEST(VerbOptions, AreReadIntoThePainting) {
  std::string wrong;
  const auto order = Read({"-o", "t.png", "--across", "--compact", "--layered", "--scale", "3",
                           "--palette", "dark", "--models", "a", "--models", "b"},
                          wrong);
  ASSERT_TRUE(order) << wrong;
  EXPECT_EQ(order->path, "t.png");
  EXPECT_EQ(order->pixels, 3);
  EXPECT_EQ(order->models.size(), 2U);
  EXPECT_EQ(order->painting.palette, PaletteName::kDark);
  EXPECT_EQ(order->painting.style.orientation, Orientation::kLeftToRight);
  EXPECT_TRUE(order->painting.style.compact && order->painting.style.layered);
}

TEST(VerbOptions, NamesWhatWasExpected) {
  std::string wrong;
  EXPECT_FALSE(Read({"-o", "t.bmp"}, wrong));
  EXPECT_NE(wrong.find(".svg"), std::string::npos);
}

}  // namespace
}  // namespace coppice::editor
