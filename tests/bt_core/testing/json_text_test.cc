#include "bt_core/testing/json_text.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

using Kind = JsonText::Kind;

JsonText Parsed(const std::string& text) {
  Diagnostics diagnostics;
  auto json = ParseJsonText(text, "a.json", diagnostics);
  EXPECT_TRUE(json) << diagnostics.ToString();
  return json ? *std::move(json) : JsonText();
}

std::string Errors(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(ParseJsonText(text, "a.json", diagnostics)) << text;
  return diagnostics.ToString();
}

std::string At(const JsonText& json) {
  return std::to_string(json.where.line) + ":" + std::to_string(json.where.column);
}

TEST(JsonText, KeepsTextAndPlaceOfEveryValue) {
  const JsonText json = Parsed(
      "{\n"
      "  \"name\": \"a \\\"b\\\"\\\\\",\n"
      "  \"list\": [1, -2.50, true,\n"
      "    null, {\"x\": false}, 3e5]\n"
      "}\n");
  EXPECT_EQ(At(json), "1:1");
  const JsonText& name = *json.Find("name");
  EXPECT_EQ(name.text, "a \"b\"\\");
  EXPECT_EQ(At(name), "2:11");
  const JsonText& list = *json.Find("list");
  EXPECT_EQ(At(list), "3:11");
  ASSERT_EQ(list.children.size(), 6U);
  EXPECT_EQ(list.children[1].text, "-2.50") << "as it is written";
  EXPECT_EQ(At(list.children[0]), "3:12");
  EXPECT_EQ(At(list.children[1]), "3:15");
  EXPECT_EQ(At(list.children[2]), "3:22");
  EXPECT_TRUE(list.children[3].is(Kind::kNull));
  EXPECT_EQ(At(list.children[3]), "4:5");
  EXPECT_EQ(At(list.children[4]), "4:11");
  EXPECT_EQ(At(*list.children[4].Find("x")), "4:17");
  EXPECT_EQ(list.children[5].text, "3e5");
  EXPECT_EQ(At(list.children[5]), "4:25");
}

TEST(JsonText, AValueMayBeTheWholeText) {
  EXPECT_EQ(Parsed("42").text, "42");
  EXPECT_EQ(Parsed(R"("")").text, "");
  EXPECT_EQ(At(Parsed("\n\n  \"\"")), "3:3");
}

TEST(JsonText, AllowsComments) {
  EXPECT_EQ(Parsed("// first\n{/* why */\"a\": 1}").Find("a")->text, "1");
}

TEST(JsonText, SaysWhereATextIsNoJson) {
  EXPECT_EQ(Errors("{\n  \"a\": 1,\n  \"b\" 2\n}").rfind("a.json:3:7: error:", 0), 0U)
      << Errors("{\n  \"a\": 1,\n  \"b\" 2\n}");
  EXPECT_NE(Errors("").find("a.json:1:1: error:"), std::string::npos) << Errors("");
  EXPECT_FALSE(Errors("[1, 2").empty());
  EXPECT_FALSE(Errors(R"({"a": tru})").empty());
  EXPECT_FALSE(Errors("\"\xFF\"").empty());
}

TEST(JsonText, ANameGivenTwiceIsAnError) {
  EXPECT_EQ(Errors("{\"a\": 1,\n \"a\": 2}"), "a.json:2:7: error: \"a\" is given twice\n");
}

TEST(JsonText, RefusesDeepNesting) {
  EXPECT_NE(Errors(std::string(100000, '[')).find("100 levels"), std::string::npos);
}

TEST(JsonText, FindsNothingUnderAnUnknownName) {
  EXPECT_EQ(Parsed("{}").Find("a"), nullptr);
  EXPECT_EQ(Parsed("5").Find("a"), nullptr);
}

}  // namespace
}  // namespace coppice
