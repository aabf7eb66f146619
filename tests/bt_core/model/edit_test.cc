#include "bt_core/model/edit.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

const Edit kEdit = {{1, 2, "XYZ"}, {4, 0, "+"}, {6, 3, ""}};
constexpr const char* kText = "abcdefghij";

TEST(Edit, ReplacesInsertsAndRemoves) { EXPECT_EQ(Apply(kEdit, kText), "aXYZd+efj"); }

TEST(Edit, AnEmptyEditChangesNothing) {
  EXPECT_EQ(Apply({}, kText), kText);
  EXPECT_TRUE(Inverse({}, kText).empty());
  EXPECT_EQ(MapOffset({}, 5), 5U);
}

TEST(Edit, TheInverseRestoresTheText) {
  const std::string after = Apply(kEdit, kText);
  const Edit undo = Inverse(kEdit, kText);
  EXPECT_EQ(Apply(undo, after), kText);
  EXPECT_EQ(Apply(Inverse(undo, after), kText), after) << "redo";
}

TEST(Edit, TellsWhereBytesHaveGone) {
  const std::string after = Apply(kEdit, kText);
  for (const char kept : {'a', 'd', 'e', 'f', 'j'}) {
    const auto before = static_cast<std::uint32_t>(std::string(kText).find(kept));
    EXPECT_EQ(MapOffset(kEdit, before), after.find(kept)) << kept;
  }
  EXPECT_EQ(MapOffset(kEdit, 2), 1U) << "replaced";
  EXPECT_EQ(MapOffset(kEdit, 7), after.find('j')) << "removed";
  EXPECT_EQ(MapOffset(kEdit, 10), after.size()) << "the end";
}

TEST(Edit, TwoEditsOfDifferentPlacesAreOne) {
  const Edit merged = Merge({{6, 3, ""}}, {{1, 2, "XYZ"}, {4, 0, "+"}});
  EXPECT_EQ(Apply(merged, kText), Apply(kEdit, kText));
}

}  // namespace
}  // namespace coppice
