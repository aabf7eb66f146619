#include "bt_core/testing/json_fields.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

using Kind = JsonValue::Kind;

class Fields : public JsonFields {
 public:
  using JsonFields::JsonFields;
  using JsonFields::ListOf;
  using JsonFields::MembersOf;
  using JsonFields::ReadBool;
  using JsonFields::ReadChoice;
  using JsonFields::ReadCount;
  using JsonFields::ReadMilliseconds;
  using JsonFields::ReadSeed;
  using JsonFields::ReadStatus;
  using JsonFields::ReadText;
  using JsonFields::ReadValues;
  using JsonFields::Unknown;
};

class JsonFieldsTest : public testing::Test {
 protected:
  // The value of the member "it".
  JsonValue It(const std::string& value) {
    const auto json = ParseJson("{\"it\": " + value + "}", "a.json", diagnostics_);
    EXPECT_TRUE(json) << diagnostics_.ToString();
    return json ? json->children.at(0) : JsonValue();
  }
  // What has been said since the last call, without the place.
  std::string Said() {
    std::string text;
    for (const Diagnostic& one : diagnostics_.all()) text += one.message + "; ";
    diagnostics_ = {};
    return text;
  }

  Diagnostics diagnostics_;
  Fields fields_{diagnostics_};
};

TEST_F(JsonFieldsTest, ReadsWhatIsThere) {
  EXPECT_TRUE(fields_.ReadBool(It("true")));
  EXPECT_EQ(fields_.ReadText(It("\"x\"")), "x");
  EXPECT_EQ(fields_.ReadCount(It("12")), 12);
  EXPECT_EQ(fields_.ReadSeed(It("9223372036854775807")), 9223372036854775807U);
  EXPECT_EQ(fields_.ReadMilliseconds(It("1.5")), std::chrono::microseconds(1500));
  EXPECT_EQ(fields_.ReadStatus(It("\"RUNNING\"")), Status::kRunning);
  EXPECT_EQ(fields_.ListOf(It("[1, 2]")).size(), 2U);
  EXPECT_EQ(fields_.MembersOf(It("{\"a\": 1}")).size(), 1U);
  EXPECT_EQ(Said(), "");
}

TEST_F(JsonFieldsTest, AnotherKindIsAnErrorAndReadsAsSomethingHarmless) {
  EXPECT_FALSE(fields_.ReadBool(It("1")));
  EXPECT_EQ(Said(), "\"it\" must be a boolean, not a number; ");
  EXPECT_EQ(fields_.ReadText(It("null")), "");
  EXPECT_EQ(Said(), "\"it\" must be a text, not null; ");
  EXPECT_EQ(fields_.ReadCount(It("\"3\"")), 0);
  EXPECT_EQ(Said(), "\"it\" must be a number, not a text; ");
  EXPECT_TRUE(fields_.ListOf(It("{}")).empty());
  EXPECT_EQ(Said(), "\"it\" must be a list, not an object; ");
  EXPECT_TRUE(fields_.MembersOf(It("[1]")).empty());
  EXPECT_EQ(Said(), "\"it\" must be an object, not a list; ");
}

TEST_F(JsonFieldsTest, NumbersHaveLimits) {
  fields_.ReadCount(It("1.5"));
  EXPECT_EQ(Said(), "expected a whole number from 0 to 1000000; ");
  EXPECT_EQ(fields_.ReadCount(It("-1")), 0);
  EXPECT_EQ(Said(), "expected a whole number from 0 to 1000000; ");
  EXPECT_EQ(fields_.ReadMilliseconds(It("1e13")), Duration(0));
  EXPECT_EQ(Said(), "expected a time in milliseconds, not negative; ");
  EXPECT_EQ(fields_.ReadSeed(It("-1")), 0U);
  EXPECT_EQ(Said(), "expected a whole number, not negative; ");
}

TEST_F(JsonFieldsTest, ValuesKnowWhatTheyAreAndWhereTheyStand) {
  const auto values = fields_.ReadValues(It(R"({"a": 0.5, "b": true, "c": "x"})"));
  ASSERT_EQ(values.size(), 3U);
  EXPECT_EQ(values[0].kind, KeyValue::Kind::kNumber);
  EXPECT_EQ(values[1].kind, KeyValue::Kind::kBool);
  EXPECT_EQ(values[2].kind, KeyValue::Kind::kString);
  EXPECT_EQ(values[2].key + values[2].text, "cx");
  EXPECT_EQ(values[2].where.column, 35);
  fields_.ReadValues(It(R"({"a": [1]})"));
  EXPECT_EQ(Said(), "expected a text, a number or a boolean; ");
}

TEST_F(JsonFieldsTest, AChoiceIsOneValueOrAList) {
  EXPECT_EQ(fields_.ReadChoice(It("3")).size(), 1U);
  const auto list = fields_.ReadChoice(It("[1, \"x\"]"));
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1].key + list[1].text, "itx");
  EXPECT_EQ(Said(), "");
  fields_.ReadChoice(It("[]"));
  EXPECT_EQ(Said(), "expected at least one value; ");
}

TEST_F(JsonFieldsTest, AnUnknownNameHasTheNearestRightOneAsAHint) {
  fields_.Unknown(It("1"), {"if", "set"});
  EXPECT_EQ(diagnostics_.all().at(0).message, "unknown member \"it\", expected if, set");
  EXPECT_NE(diagnostics_.all().at(0).hint.find("if"), std::string::npos);
}

}  // namespace
}  // namespace coppice
