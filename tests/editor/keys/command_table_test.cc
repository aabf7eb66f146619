#include "editor/keys/command_table.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace coppice::editor {
namespace {

TEST(CommandTable, RunsByIdAndByKey) {
  CommandTable table;
  int runs = 0;
  table.Add({"a", "A", {'A', kCtrl}, [&] { ++runs; }});
  EXPECT_TRUE(table.Run("a"));
  EXPECT_TRUE(table.Press({'A', kCtrl}));
  EXPECT_FALSE(table.Press({'A', kNoModifier}));
  EXPECT_FALSE(table.Run("b"));
  EXPECT_EQ(runs, 2);
}

TEST(CommandTable, RefusesAnIdOrAKeyTwice) {
  CommandTable table;
  table.Add({"a", "A", {'A'}, [] {}});
  EXPECT_THROW(table.Add({"a", "B", {'B'}, [] {}}), std::invalid_argument);
  EXPECT_THROW(table.Add({"b", "B", {'A'}, [] {}}), std::invalid_argument);
  EXPECT_NO_THROW(table.Add({"c", "C", {}, [] {}}));
  EXPECT_NO_THROW(table.Add({"d", "D", {}, [] {}})) << "commands without a key do not clash";
}

}  // namespace
}  // namespace coppice::editor
