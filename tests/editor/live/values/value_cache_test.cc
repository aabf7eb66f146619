#include "editor/live/values/value_cache.h"

#include <gtest/gtest.h>

#include "bt_core/data/value_bytes.h"

namespace coppice::editor {
namespace {

std::string Bytes(const std::string& json) { return static_cast<char>(ValueForm::kJson) + json; }

TEST(ValueCacheTest, AValueIsReadOnceUntilItChanges) {
  ValueCache cache;
  std::string bytes = Bytes("[1, 2]");
  for (int tick = 0; tick < 3; ++tick) {
    cache.Look("tick " + std::to_string(tick));
    EXPECT_NE(cache.Of("Main/a", bytes).rows(), nullptr);
  }
  EXPECT_EQ(cache.Of("Main/a", bytes).readings(), 1);
  bytes = Bytes("[1, 3]");
  cache.Look("another tick");
  ASSERT_NE(cache.Of("Main/a", bytes).rows(), nullptr);
  EXPECT_EQ(cache.Of("Main/a", bytes).readings(), 2);
}

TEST(ValueCacheTest, WhatWasFoldedStaysFoldedWhenTheValueChanges) {
  ValueCache cache;
  cache.Look("1");
  std::string bytes = Bytes("{\"a\": [1, 2]}");
  SlotView& view = cache.Of("Main/a", bytes);
  EXPECT_EQ(view.Shown("").size(), 3U);
  view.Turn(1);
  EXPECT_EQ(view.Shown("").size(), 1U);
  bytes = Bytes("{\"a\": [1, 2, 3]}");
  cache.Look("2");
  EXPECT_EQ(cache.Of("Main/a", bytes).Shown("").size(), 1U);
}

TEST(ValueCacheTest, ASearchFindsWithinTheValue) {
  ValueCache cache;
  cache.Look("1");
  const std::string bytes = Bytes("{\"a\": [1, 2], \"b\": \"Kitchen\"}");
  SlotView& view = cache.Of("Main/a", bytes);
  EXPECT_TRUE(view.IsFound("Main/a", "kitchen"));
  EXPECT_FALSE(view.IsFound("Main/a", "bath"));
  EXPECT_EQ(view.Shown("kitchen").size(), 1U);
  EXPECT_EQ(view.Shown("main").size(), 4U) << "the key alone has it: as without a search";
}

TEST(ValueCacheTest, ALongTextIsPrintedInPart) {
  EXPECT_EQ(PrintBeginning(Bytes("[1,2,3]"), 2), "[1 ... (7 bytes in all)");
  EXPECT_EQ(PrintBeginning(Bytes("[1]"), 20), "[1]");
  EXPECT_EQ(PrintBeginning("", 20), "");
}

}  // namespace
}  // namespace coppice::editor
