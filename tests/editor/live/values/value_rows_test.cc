#include "editor/live/values/value_rows.h"

#include <gmock/gmock.h>

namespace coppice::editor {
namespace {

using testing::ElementsAre;

std::vector<std::string> Paths(const ValueRows& rows, const std::vector<std::uint32_t>& numbers) {
  std::vector<std::string> paths;
  for (const std::uint32_t row : numbers) paths.push_back(rows.PathOf(row));
  return paths;
}

std::string ListOf(int count) {
  std::string text = "[0";
  for (int i = 1; i < count; ++i) text += "," + std::to_string(i);
  return text + "]";
}

TEST(ValueRowsTest, ARowKnowsItsNameItsTextAndItsPlace) {
  const auto rows = ReadValueRows(R"( {"a": [1, -2.5e3 ], "b": "x\"]y", "c": {}} )");
  ASSERT_TRUE(rows.has_value());
  ASSERT_EQ(rows->rows.size(), 6U);
  EXPECT_EQ(rows->KeyOf(rows->rows[1]), "a");
  EXPECT_EQ(rows->TextOf(rows->rows[1]), "[1, -2.5e3 ]");
  EXPECT_EQ(rows->TextOf(rows->rows[3]), "-2.5e3");
  EXPECT_EQ(rows->PathOf(3), "/a/1");
  EXPECT_EQ(rows->TextOf(rows->rows[4]), R"("x\"]y")");
  EXPECT_EQ(rows->rows[1].end, 4U) << "the next sibling";
  EXPECT_EQ(rows->rows[3].depth, 2U);
  EXPECT_EQ(rows->rows[0].count, 3U);
}

TEST(ValueRowsTest, WhatIsNoListAndNoObjectHasNoRows) {
  for (const char* text :
       {"", " ", "7", "\"a\"", "kitchen", "[1", "[1 2]", "[,]", "{1:2}", "{\"a\" 1}", "{\"a\":}",
        "[\"a]", "[\"a\\", "[1]]", "{]", "[}", "[1] x", "{\"a\":1,\"b\"}"}) {
    EXPECT_FALSE(ReadValueRows(text).has_value()) << text;
  }
}

TEST(ValueRowsTest, WhatIsTooDeepHasNoRows) {
  EXPECT_FALSE(ReadValueRows(std::string(100000, '[')).has_value());
  EXPECT_FALSE(ReadValueRows(std::string(300, '[') + std::string(300, ']')).has_value());
}

TEST(ValueRowsTest, FewEntriesAreOpenAndManyAreFolded) {
  const std::string text = R"({"few": [1, 2], "many": )" + ListOf(1200) + "}";
  const auto rows = ReadValueRows(text);
  ASSERT_TRUE(rows.has_value());
  EXPECT_THAT(Paths(*rows, ShownRows(*rows, {})), ElementsAre("/few", "/few/0", "/few/1", "/many"));
  EXPECT_THAT(Paths(*rows, ShownRows(*rows, {"/few"})), ElementsAre("/few", "/many"));
  EXPECT_EQ(ShownRows(*rows, {"/many"}).size(), 4U + 1200U);
}

TEST(ValueRowsTest, SizesAreReadAtAGlance) {
  const std::string text = R"({"a": )" + ListOf(1200) + R"(, "b": {"c": 1}, "d": []})";
  const auto rows = ReadValueRows(text);
  ASSERT_TRUE(rows.has_value());
  EXPECT_EQ(SizeText(rows->rows[1]), "[1 200]");
  EXPECT_EQ(SizeText(rows->rows[1202]), "{1}");
  EXPECT_EQ(SizeText(rows->rows[1204]), "[0]");
}

TEST(ValueRowsTest, TheSearchFindsNamesAndValuesAndWhatTheyAreIn) {
  const auto rows =
      ReadValueRows(R"({"rooms": [{"id": "Kitchen"}, {"id": "lab"}], "kit": 1, "z": [7]})");
  ASSERT_TRUE(rows.has_value());
  EXPECT_THAT(Paths(*rows, FoundRows(*rows, "kit")),
              ElementsAre("/rooms", "/rooms/0", "/rooms/0/id", "/kit"));
  EXPECT_TRUE(FoundRows(*rows, "bath").empty());
}

}  // namespace
}  // namespace coppice::editor
