#include "bt_core/base/json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

namespace coppice {
namespace {

using Kind = JsonValue::Kind;

JsonValue Parsed(const std::string& text) {
  Diagnostics diagnostics;
  auto json = ParseJson(text, "a.json", diagnostics);
  EXPECT_TRUE(json) << diagnostics.ToString();
  return json ? *std::move(json) : JsonValue();
}

std::string Errors(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(ParseJson(text, "a.json", diagnostics)) << text;
  return diagnostics.ToString();
}

std::string At(const JsonValue& json) {
  return std::to_string(json.where.line) + ":" + std::to_string(json.where.column);
}

TEST(JsonValue, KeepsTextAndPlaceOfEveryValue) {
  const JsonValue json = Parsed(
      "{\n"
      "  \"name\": \"a \\\"b\\\"\\\\\",\n"
      "  \"list\": [1, -2.50, true,\n"
      "    null, {\"x\": false}, 3e5]\n"
      "}\n");
  EXPECT_EQ(At(json), "1:1");
  const JsonValue& name = *json.Find("name");
  EXPECT_EQ(name.text, "a \"b\"\\");
  EXPECT_EQ(At(name), "2:11");
  const JsonValue& list = *json.Find("list");
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

TEST(JsonValue, AValueMayBeTheWholeText) {
  EXPECT_EQ(Parsed("42").text, "42");
  EXPECT_EQ(Parsed(R"("")").text, "");
  EXPECT_EQ(At(Parsed("\n\n  \"\"")), "3:3");
}

TEST(JsonValue, AllowsComments) {
  EXPECT_EQ(Parsed("// first\n{/* why */\"a\": 1}").Find("a")->text, "1");
}

TEST(JsonValue, SaysWhereATextIsNoJson) {
  EXPECT_EQ(Errors("{\n  \"a\": 1,\n  \"b\" 2\n}").rfind("a.json:3:7: error:", 0), 0U)
      << Errors("{\n  \"a\": 1,\n  \"b\" 2\n}");
  EXPECT_NE(Errors("").find("a.json:1:1: error:"), std::string::npos) << Errors("");
  EXPECT_FALSE(Errors("[1, 2").empty());
  EXPECT_FALSE(Errors(R"({"a": tru})").empty());
  EXPECT_FALSE(Errors("\"\xFF\"").empty());
}

TEST(JsonValue, ANameGivenTwiceIsAnError) {
  EXPECT_EQ(Errors("{\"a\": 1,\n \"a\": 2}"), "a.json:2:7: error: \"a\" is given twice\n");
}

TEST(JsonValue, RefusesDeepNesting) {
  EXPECT_NE(Errors(std::string(100000, '[')).find("100 levels"), std::string::npos);
}

TEST(JsonValue, RefusesMoreValuesThanAnybodyWrites) {
  std::string list = "[0";
  for (std::size_t i = 0; i < kMostJsonValues; ++i) list += ",0";
  EXPECT_EQ(Errors(list + "]"), "a.json:1:800000: error: more than 400000 values\n");
}

TEST(JsonValue, FindsNothingUnderAnUnknownName) {
  EXPECT_EQ(Parsed("{}").Find("a"), nullptr);
  EXPECT_EQ(Parsed("5").Find("a"), nullptr);
}

TEST(JsonString, WritesAnyTextSoThatItCanBeReadBack) {
  for (const std::string text : {"", "plain", "\"quoted\" \\ and \n\t\x01\x7f",
                                 "n\xc3\xa4her \xe2\x82\xac \xf0\x9f\xa4\x96"}) {
    EXPECT_EQ(nlohmann::json::parse(JsonString(text)), text);
  }
}

TEST(JsonString, ReplacesBytesThatAreNotUtf8) {
  std::mt19937 random(4);
  for (int i = 0; i < 5000; ++i) {
    std::string text(random() % 12, '\0');
    for (char& c : text) c = static_cast<char>(random());
    EXPECT_NO_THROW(nlohmann::json::parse(JsonString(text))) << JsonString(text);
  }
}

TEST(JsonObject, IsOneObject) {
  JsonObject object;
  object.AddText("a", "b").Add("n", std::uint64_t{7}).AddBool("yes", true);
  object.Add("t", JsonSeconds(std::chrono::milliseconds(1500)));
  EXPECT_EQ(object.Finish(), "{\"a\":\"b\",\"n\":7,\"yes\":true,\"t\":1.500000000}");
}

TEST(ParseJson, OfProgramsHasNoComments) {
  EXPECT_TRUE(ParseJson(R"({"a": [1, "x"]})"));
  EXPECT_FALSE(ParseJson("{} // that is all"));
  EXPECT_FALSE(ParseJson(std::string(1'000'000, '[')));
}

}  // namespace
}  // namespace coppice
