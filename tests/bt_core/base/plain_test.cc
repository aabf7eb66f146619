#include "bt_core/base/plain.h"

#include <gtest/gtest.h>

#include "bt_core/base/json.h"

namespace coppice {
namespace {

TEST(Plain, WritesOutWhatATerminalObeys) {
  EXPECT_EQ(Plain("a\x1B[31m\r\b"), R"(a\x1B[31m\x0D\x08)");
  EXPECT_EQ(Plain("a\xC2\x9B"
                  "31m\x7F"),
            R"(a\u009B31m\u007F)");
}

TEST(Plain, LeavesLettersOfAllLanguagesLinesAndTabs) {
  const std::string text = "K\u00FCche \u00A0\n\t\u4E16\u754C \U0001F916";
  EXPECT_EQ(Plain(text), text);
  EXPECT_EQ(PlainLine("a\nb"), R"(a\nb)");
}

TEST(Plain, IsInJsonTheSameText) {
  const std::string text = "a\x7F\xC2\x9B\x1B";
  const std::string json = JsonString(text);
  EXPECT_EQ(json, Plain(json));
  const auto read = ParseJson(json);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->text, text);
}

}  // namespace
}  // namespace coppice
