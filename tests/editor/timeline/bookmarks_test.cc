#include "editor/timeline/bookmarks.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(Bookmarks, AreFoundFromWhereTheUserIs) {
  Bookmarks bookmarks;
  bookmarks.Set("a.coppice", 10, "it begins");
  bookmarks.Set("a.coppice", 20, "it ends");
  bookmarks.Set("b.coppice", 15, "elsewhere");
  EXPECT_EQ(bookmarks.Next("a.coppice", 0)->second, "it begins");
  EXPECT_EQ(bookmarks.Next("a.coppice", 10)->second, "it ends");
  EXPECT_EQ(bookmarks.Next("a.coppice", 20), nullptr);
  EXPECT_EQ(bookmarks.Before("a.coppice", 20)->first, 10U);
  EXPECT_EQ(bookmarks.Before("a.coppice", 10), nullptr);
  EXPECT_EQ(bookmarks.Before("c.coppice", 10), nullptr);
}

TEST(Bookmarks, ARunWithoutAnyIsForgotten) {
  Bookmarks bookmarks;
  bookmarks.Set("a.coppice", 10, "it begins");
  bookmarks.Remove("a.coppice", 11);
  EXPECT_EQ(bookmarks.Of("a.coppice").size(), 1U);
  bookmarks.Remove("a.coppice", 10);
  EXPECT_TRUE(bookmarks.all().empty());
}

}  // namespace
}  // namespace coppice::editor
