#include "bt_core/data/json.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "bt_core/data/standard_types.h"
#include "bt_core/data/value.h"

namespace coppice {

struct Point {
  double x = 0;
  std::string label;
  std::vector<int> marks;
};
struct Segment {
  Point from;
  Point to;
};
struct Plain {
  int number = 0;
};

template <>
struct ValueTraits<Point> : JsonTraits<Point> {
  static constexpr const char* kName = "Point";
  template <class Fields, class P>
  static void List(Fields& fields, P& point) {
    fields("x", point.x)("label", point.label)("marks", point.marks);
  }
};
template <>
struct ValueTraits<Segment> : JsonTraits<Segment> {
  static constexpr const char* kName = "Segment";
  template <class Fields, class S>
  static void List(Fields& fields, S& segment) {
    fields("from", segment.from)("to", segment.to);
  }
};
template <>
struct ValueTraits<Plain> {
  static constexpr const char* kName = "Plain";
  static bool Parse(std::string_view text, Plain& out) {
    return text.substr(0, 1) == "#" && ValueTraits<int>::Parse(text.substr(1), out.number);
  }
  static std::string Print(const Plain& value) { return "#" + std::to_string(value.number); }
};

namespace {

template <class T>
std::string JsonOf(const T& value) {
  return Value(value).ToJson();
}

template <class T>
std::string TextOf(std::string_view json) {
  Value value;
  return value.FromJson(TypeOf<T>(), json) ? value.Print() : "no";
}

TEST(Json, NumbersAndTruthValuesAreThemselves) {
  EXPECT_EQ(JsonOf(5), "5");
  EXPECT_EQ(JsonOf(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
  EXPECT_EQ(JsonOf(0.1), "0.1");
  EXPECT_EQ(JsonOf(0.1F), "0.1");
  EXPECT_EQ(JsonOf(true), "true");
  EXPECT_EQ(JsonOf(std::numeric_limits<double>::infinity()), "\"inf\"");
  EXPECT_EQ(Value().ToJson(), "null");
}

TEST(Json, EverythingElseIsAStringOfItsText) {
  EXPECT_EQ(JsonOf(std::string("a \"b\"\n")), R"("a \"b\"\n")");
  EXPECT_EQ(JsonOf(std::string("\xFF")), "\"\xEF\xBF\xBD\"") << "no UTF-8";
  EXPECT_EQ(JsonOf(Plain{7}), "\"#7\"");
  EXPECT_EQ(JsonOf(Status::kSuccess), "\"SUCCESS\"");
}

TEST(Json, ListsAreArrays) {
  EXPECT_EQ(JsonOf(std::vector<int>{1, -2}), "[1,-2]");
  EXPECT_EQ(JsonOf(std::vector<std::string>{"a;b", "c"}), R"(["a;b","c"])");
  EXPECT_EQ(JsonOf(std::vector<bool>{}), "[]");
  EXPECT_EQ(TextOf<std::vector<double>>("[1, 2.5]"), "1;2.5");
  EXPECT_EQ(TextOf<std::vector<int>>("[1, 2.5]"), "no");
  EXPECT_EQ(TextOf<std::vector<int>>("{}"), "no");
}

TEST(Json, IsReadWithTheTypesOwnStrictness) {
  EXPECT_EQ(TextOf<int>(" 5 "), "5");
  EXPECT_EQ(TextOf<int>("\"5\""), "5");
  EXPECT_EQ(TextOf<double>("\"inf\""), "inf");
  EXPECT_EQ(TextOf<bool>("true"), "true");
  EXPECT_EQ(TextOf<Status>("\"FAILURE\""), "FAILURE");
  EXPECT_EQ(TextOf<Status>("3"), "FAILURE");
  EXPECT_EQ(TextOf<Plain>("\"#7\""), "#7");
  EXPECT_EQ(TextOf<std::string>("\"a\\u00e9\""), "a\u00e9");
  for (const char* bad : {"", "5.5", "[5]", "null", "5 5", "nonsense", "99999999999"}) {
    EXPECT_EQ(TextOf<int>(bad), "no") << bad;
  }
  EXPECT_EQ(TextOf<std::string>("5"), "no");
}

TEST(Json, AStructIsAnObject) {
  const Segment segment = {{1.5, "a", {1}}, {-2, "b", {}}};
  const std::string json = JsonOf(segment);
  EXPECT_EQ(json,
            R"({"from":{"x":1.5,"label":"a","marks":[1]},"to":{"x":-2,"label":"b","marks":[]}})");
  EXPECT_EQ(TextOf<Segment>(json), "json:" + json);
  EXPECT_EQ(TextOf<Point>(R"({"marks":[1],"__type":"Point","x":2,"label":""})"),
            R"(json:{"x":2,"label":"","marks":[1]})");
}

TEST(Json, EveryFieldMustBeThereAndNoOther) {
  EXPECT_EQ(TextOf<Point>(R"({"x":1,"label":""})"), "no");
  EXPECT_EQ(TextOf<Point>(R"({"x":1,"label":"","marks":[],"y":1})"), "no");
  EXPECT_EQ(TextOf<Point>(R"({"x":"one","label":"","marks":[]})"), "no");
  EXPECT_EQ(TextOf<Point>("[]"), "no");
}

TEST(Json, IsALiteralBehindItsPrefix) {
  Value value;
  EXPECT_TRUE(value.Parse(TypeOf<Point>(), R"(json:{"x":1,"label":"","marks":[]})"));
  EXPECT_TRUE(value.Parse(TypeOf<std::vector<int>>(), "json:[1,2]"));
  EXPECT_EQ(value.Print(), "1;2");
  EXPECT_FALSE(value.Parse(TypeOf<Point>(), R"({"x":1,"label":"","marks":[]})"));
  EXPECT_FALSE(value.Parse(TypeOf<Plain>(), "json:\"#7\"")) << "has no JSON of its own";
  EXPECT_TRUE(value.Parse(TypeOf<std::string>(), "json:[1,2]"));
  EXPECT_EQ(value.Print(), "json:[1,2]") << "a string is any text";
}

TEST(Json, NoTextExhaustsTheStack) {
  const std::string deep(1'000'000, '[');
  Value value;
  EXPECT_FALSE(value.FromJson(TypeOf<std::vector<int>>(), deep));
  EXPECT_FALSE(value.FromJson(TypeOf<std::vector<int>>(), deep + std::string(deep.size(), ']')));
  EXPECT_FALSE(value.FromJson(TypeOf<int>(), deep));
}

}  // namespace
}  // namespace coppice
