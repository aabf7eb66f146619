#include "editor/theme/item_registry.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(ItemRegistry, FindsTheLastBoxOfAPath) {
  ItemRegistry items;
  items.Add("a/b", {{0, 0}, {1, 1}});
  items.Add("a/b", {{2, 2}, {3, 3}});
  ASSERT_NE(items.Find("a/b"), nullptr);
  EXPECT_EQ(items.Find("a/b")->min.x, 2);
  EXPECT_EQ(items.Find("a"), nullptr);
  items.Clear();
  EXPECT_EQ(items.Find("a/b"), nullptr);
}

}  // namespace
}  // namespace coppice::editor
