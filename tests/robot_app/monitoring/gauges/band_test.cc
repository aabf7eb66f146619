#include "robot_app/monitoring/gauges/band.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr auto kOk = HealthLevel::kOk;
constexpr auto kWarn = HealthLevel::kWarn;
constexpr auto kError = HealthLevel::kError;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Band TwoSided() { return {{20, 25}, {18, 28}, 1, Duration::zero(), 0}; }
Band AtMost(double warn, double error, int consecutive = 1, double hysteresis = 0) {
  return {{std::nullopt, warn}, {std::nullopt, error}, consecutive, Duration::zero(), hysteresis};
}

struct Row {
  const char* name;
  Band band;
  std::vector<double> values;
  std::vector<HealthLevel> levels;  // after each value
};

class BandTable : public testing::TestWithParam<Row> {};

TEST_P(BandTable, GivesTheLevelsOfTheRow) {
  const Row& row = GetParam();
  Judge judge(row.band);
  for (std::size_t i = 0; i < row.values.size(); ++i) {
    judge.OnValue(row.values[i], Time(seconds(i)));
    EXPECT_EQ(judge.Assess(Time(seconds(i))).level, row.levels[i])
        << row.values[i] << ", number " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Band, BandTable,
    testing::Values(
        Row{"BothSidesWithEdgesWithin",
            TwoSided(),
            {22, 20, 19.9, 18, 17.9, 25, 25.1, 28, 28.1},
            {kOk, kOk, kWarn, kWarn, kError, kOk, kWarn, kWarn, kError}},
        Row{"NoBoundNoAlarm", Band(), {-1e9, 0, 1e9, kNan}, {kOk, kOk, kOk, kOk}},
        Row{"NotANumberIsAnError", TwoSided(), {kNan}, {kError}},
        Row{"ErrorWithoutWarnBounds",
            {{}, {10, std::nullopt}, 1, Duration::zero(), 0},
            {10, 9},
            {kOk, kError}},
        Row{"ThreeInARowMakeAnErrorFewerAWarning",
            AtMost(90, 95, 3),
            {96, 96, 96, 50, 96, 50},
            {kWarn, kWarn, kError, kOk, kWarn, kOk}},
        Row{"ThreeInARowMakeAWarning", AtMost(90, 95, 3), {92, 92, 92, 50}, {kOk, kOk, kWarn, kOk}},
        Row{"AnErrorAmongWarningsCountsTowardsTheWarning",
            AtMost(90, 95, 2),
            {92, 96, 92, 96, 96},
            {kOk, kWarn, kWarn, kWarn, kError}},
        Row{"ABadLevelEndsOnlyWellWithinItsBound",
            AtMost(90, 95, 1, 5),
            {94, 89, 85, 89, 96, 93, 91, 90, 86, 85},
            {kWarn, kWarn, kOk, kOk, kError, kError, kError, kWarn, kWarn, kOk}}),
    [](const testing::TestParamInfo<Row>& info) { return info.param.name; });

TEST(Judge, SaysWhatItMeasuredAndWhatItExpected) {
  Judge judge(TwoSided(), "V");
  judge.OnValue(17.5, Time(seconds(1)));
  EXPECT_EQ(judge.Assess(Time(seconds(1))).message, "17.5 V, expected 18 to 28 V");
  judge.OnValue(19, Time(seconds(1)));
  EXPECT_EQ(judge.Assess(Time(seconds(1))).message, "19 V, expected 20 to 25 V");
  judge.OnValue(22, Time(seconds(1)));
  EXPECT_EQ(judge.Assess(Time(seconds(1))).message, "");
  EXPECT_EQ(judge.value(), 22);
}

TEST(Judge, SilenceIsAnErrorAfterTheStaleness) {
  Band band = TwoSided();
  band.staleness = seconds(2);
  Judge judge(band);
  EXPECT_EQ(judge.Assess(Time(seconds(10))).message, "no value yet");
  EXPECT_EQ(judge.Assess(Time(seconds(12))).level, kOk);  // exactly the limit
  EXPECT_EQ(judge.Assess(Time(seconds(12) + milliseconds(500))).message, "no value for 2.5 s");
  judge.OnValue(22, Time(seconds(13)));
  EXPECT_EQ(judge.Assess(Time(seconds(13))).level, kOk);
  EXPECT_EQ(judge.Assess(Time(seconds(16))).level, kError);
}

TEST(Judge, WithoutStalenessSilenceIsAllowed) {
  Judge judge(TwoSided());
  judge.Assess(Time(seconds(1)));
  EXPECT_EQ(judge.Assess(Time(seconds(100000))).level, kOk);
}

TEST(Judge, TimeThatJumpsBackIsNoSilence) {
  Band band = TwoSided();
  band.staleness = seconds(2);
  Judge judge(band);
  judge.OnValue(22, Time(seconds(100)));
  EXPECT_EQ(judge.Assess(Time(seconds(1))).level, kOk);
  EXPECT_EQ(judge.Assess(Time(seconds(3))).level, kOk);
  EXPECT_EQ(judge.Assess(Time(seconds(4))).level, kError);
}

TEST(Judge, AFailedMeasurementCountsAsAnErrorValue) {
  Judge judge(AtMost(90, 95, 2));
  judge.OnValue(1, Time(seconds(1)));
  judge.OnFailure("no answer", Time(seconds(2)));
  EXPECT_EQ(judge.Assess(Time(seconds(2))).level, kWarn);
  EXPECT_EQ(judge.Assess(Time(seconds(2))).message, "no answer");
  judge.OnFailure("no answer", Time(seconds(3)));
  EXPECT_EQ(judge.Assess(Time(seconds(3))).level, kError);
  judge.OnValue(1, Time(seconds(4)));
  EXPECT_EQ(judge.Assess(Time(seconds(4))).level, kOk);
}

TEST(Judge, ForgetsWhenReset) {
  Band band = TwoSided();
  band.staleness = seconds(2);
  Judge judge(band);
  judge.OnValue(0, Time(seconds(1)));
  judge.Reset();
  EXPECT_EQ(judge.Assess(Time(seconds(9))).level, kOk);
  EXPECT_FALSE(judge.value().has_value());
}

TEST(Range, HasATextForEachKind) {
  EXPECT_EQ(ToText(Range{5, 15}, "Hz"), "5 to 15 Hz");
  EXPECT_EQ(ToText(Range{std::nullopt, 0.9}, ""), "at most 0.9");
  EXPECT_EQ(ToText(Range{23, std::nullopt}, "V"), "at least 23 V");
  EXPECT_EQ(ToText(Range{}, "V"), "any");
}

TEST(Band, ABoundOnOneSideLeavesTheOtherOpen) {
  EXPECT_EQ(AtMost(1, 2, 3), (Band{{std::nullopt, 1}, {std::nullopt, 2}, 3, Duration::zero(), 0}));
  EXPECT_EQ(AtLeast(2, 1, 3, 0.5),
            (Band{{2, std::nullopt}, {1, std::nullopt}, 3, Duration::zero(), 0.5}));
}

}  // namespace
}  // namespace coppice::robot::monitoring
