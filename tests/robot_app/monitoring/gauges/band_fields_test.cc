#include "robot_app/monitoring/gauges/band_fields.h"

#include <gmock/gmock.h>

#include "tests/robot_app/monitoring/fields_fixture.h"

namespace coppice::robot::monitoring {
namespace {

using testing::HasSubstr;

class BandFieldsTest : public FieldsTest {
 protected:
  Band Read(const std::string& text, const Band& otherwise = {}) {
    YamlFields fields = Open(text);
    const Band band = ReadBand(fields, "load", otherwise);
    fields.Finish();
    return band;
  }
};

TEST_F(BandFieldsTest, ReadsAllWords) {
  const Band band = Read(
      "load: {warn: [2, 8.5], error: [-1, none], consecutive: 3, staleness: 1.5, hysteresis: 0.5}");
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(band, (Band{{2, 8.5}, {-1, std::nullopt}, 3, std::chrono::milliseconds(1500), 0.5}));
}

TEST_F(BandFieldsTest, WhatIsNotSaidIsTakenFromTheDefault) {
  const Band otherwise{{2, 8}, {1, 9}, 3, std::chrono::seconds(4), 0.5};
  EXPECT_EQ(Read("other: 1", otherwise), otherwise);
  EXPECT_THAT(Errors(), HasSubstr(R"(unknown key "other")"));
  Band expected = otherwise;
  expected.error = {0, std::nullopt};
  EXPECT_EQ(Read("load: {error: [0, none]}", otherwise), expected);
}

TEST_F(BandFieldsTest, ADefaultThatDoesNotFitGivesWay) {
  const Band otherwise{{2, 8}, {1, 9}, 1, Duration::zero(), 0};
  EXPECT_EQ(Read("load: {error: [3, 5]}", otherwise).warn, (Range{3, 5}));
  EXPECT_EQ(Read("load: {error: [none, 20]}", otherwise).warn, (Range{2, 8}));
  EXPECT_EQ(Read("load: {warn: [0, 12]}", otherwise).error, (Range{0, 12}));
  EXPECT_EQ(Errors(), "");
}

TEST_F(BandFieldsTest, ReportsEveryProblemWithItsPlaceAndAHint) {
  Read("load:\n  warm: [1, 2]\n  warn: [3, 2]\n  error: [a, 9]\n  consecutive: 0\n");
  EXPECT_THAT(Errors(), HasSubstr(R"(:2:3: error: unknown key "warm" (did you mean "warn"?))"));
  EXPECT_THAT(Errors(), HasSubstr(R"(:3:10: error: "warn": low is not below high)"));
  EXPECT_THAT(Errors(), HasSubstr(R"(:4:11: error: "error": expected a number or none, got "a")"));
  EXPECT_THAT(Errors(), HasSubstr(R"(:5:16: error: "consecutive": 0 is not within 1 and 1000)"));
}

TEST_F(BandFieldsTest, BoundsMustFitTogether) {
  Read("load: {warn: [1, 9], error: [2, 8]}");
  EXPECT_THAT(Errors(), HasSubstr(R"(:1:7: error: "warn" is not within "error")"));
  Read("load: {warn: [1, 2], hysteresis: 0.5}");
  EXPECT_THAT(Errors(), HasSubstr(R"("hysteresis" leaves no room between low and high)"));
  Read("load: {warn: [1]}");
  EXPECT_THAT(Errors(), HasSubstr("expected [low, high]"));
  Read("load: {warn: [nan, 3]}");
  EXPECT_THAT(Errors(), HasSubstr(R"(expected a number or none, got "nan")"));
}

TEST_F(BandFieldsTest, RosNamesBeginWithASlash) {
  YamlFields fields = Open("{a: /good, b: bad}");
  EXPECT_EQ(ReadRosName(fields, "a"), "/good");
  EXPECT_EQ(ReadRosName(fields, "missing", "/default"), "/default");
  EXPECT_EQ(Errors(), "");
  ReadRosName(fields, "b", "/default");
  EXPECT_THAT(Errors(), HasSubstr(R"("b": expected a ROS name with slash, got "bad")"));
}

TEST_F(BandFieldsTest, RosNamesHaveNeitherBlanksNorBrackets) {
  YamlFields fields = Open("{a: /g/o_0d, b: '/{bad}', c: /bad one}");
  ReadRosName(fields, "a");
  EXPECT_EQ(Errors(), "");
  ReadRosName(fields, "b");
  EXPECT_THAT(Errors(), HasSubstr(R"("b": expected a ROS name with slash, got "/{bad}")"));
  ReadRosName(fields, "c");
  EXPECT_THAT(Errors(), HasSubstr(R"("c": expected a ROS name)"));
}

TEST_F(BandFieldsTest, ANameListedTwiceIsAnError) {
  CheckUnique(Open("a: 1"), {"x", "y"});
  EXPECT_EQ(Errors(), "");
  CheckUnique(Open("a: 1"), {"x", "y", "x"});
  EXPECT_THAT(Errors(), HasSubstr(R"("x" is listed twice)"));
}

}  // namespace
}  // namespace coppice::robot::monitoring
