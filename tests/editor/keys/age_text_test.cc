#include "editor/keys/age_text.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(AgeText, CountsInTheLargestUnitThatFits) {
  EXPECT_EQ(AgeText(59), "a moment ago");
  EXPECT_EQ(AgeText(60), "1 minute ago");
  EXPECT_EQ(AgeText(3 * 3600), "3 hours ago");
  EXPECT_EQ(AgeText(12 * 86400), "12 days ago");
}

TEST(AgeText, AClockThatWasSetBackIsNoHarm) { EXPECT_EQ(AgeText(-5000), "a moment ago"); }

}  // namespace
}  // namespace coppice::editor
