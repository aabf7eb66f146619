#include "bt_core/model/manifest.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

TEST(NodeCategory, ReadsBackItsXmlName) {
  for (const NodeCategory category :
       {NodeCategory::kAction, NodeCategory::kCondition, NodeCategory::kControl,
        NodeCategory::kDecorator, NodeCategory::kSubTree}) {
    EXPECT_EQ(CategoryFromTag(ToString(category)), category);
  }
}

TEST(NodeCategory, OtherTagsAreNone) {
  EXPECT_EQ(CategoryFromTag("Sequence"), std::nullopt);
  EXPECT_EQ(CategoryFromTag("action"), std::nullopt);
  EXPECT_EQ(CategoryFromTag(""), std::nullopt);
}

TEST(ReservedAttributes, AreNameIdAndUnderscore) {
  EXPECT_TRUE(IsReservedAttribute("name"));
  EXPECT_TRUE(IsReservedAttribute("ID"));
  EXPECT_TRUE(IsReservedAttribute("_skipIf"));
  EXPECT_FALSE(IsReservedAttribute("goal"));
  EXPECT_FALSE(IsReservedAttribute("id"));
  EXPECT_FALSE(IsReservedAttribute(""));
}

}  // namespace
}  // namespace coppice
