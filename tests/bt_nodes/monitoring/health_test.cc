#include "bt_nodes/monitoring/health.h"

#include <gtest/gtest.h>

namespace coppice::leaves {
namespace {

Health Example() {
  Health health;
  health.stamp = Time(std::chrono::seconds(7));
  health.entries = {{"node", "/a", "/a", HealthLevel::kOk, ""},
                    {"node", "/b", "/b", HealthLevel::kError, "does not answer"},
                    {"topic", "/scan", "/b", HealthLevel::kStale, "monitor is silent"},
                    {"navigation", "path", "", HealthLevel::kWarn, "blocked"}};
  return health;
}

TEST(Health, FindsTheFirstErrorOfAKindOfMonitor) {
  const Health health = Example();
  ASSERT_NE(health.FirstError("node"), nullptr);
  EXPECT_EQ(health.FirstError("node")->subject, "/b");
}

TEST(Health, CountsStaleAsAnError) { EXPECT_NE(Example().FirstError("topic"), nullptr); }

TEST(Health, CountsAWarningAsNoError) { EXPECT_EQ(Example().FirstError("navigation"), nullptr); }

TEST(Health, ALevelThatThereIsNotIsTheWorst) {
  EXPECT_EQ(LevelOfNumber(1), HealthLevel::kWarn);
  for (const int number : {-1, 4, 200}) EXPECT_EQ(LevelOfNumber(number), HealthLevel::kStale);
}

TEST(Health, ReadsBackWhatItPrints) {
  Health read;
  const std::string text = ValueTraits<Health>::Print(Example());
  ASSERT_TRUE(ValueTraits<Health>::Parse(text, read));
  EXPECT_EQ(ValueTraits<Health>::Print(read), text);
  EXPECT_EQ(read.entries.size(), 4u);
  EXPECT_EQ(read.entries[1].message, "does not answer");
}

TEST(Health, KeepsSeparatorsOutOfTheTextForm) {
  Health health;
  health.entries = {{"node", "/a", "/a", HealthLevel::kOk, "two\nlines\tand a tab"}};
  Health read;
  ASSERT_TRUE(ValueTraits<Health>::Parse(ValueTraits<Health>::Print(health), read));
  EXPECT_EQ(read.entries.at(0).message, "two lines and a tab");
}

TEST(Health, RefusesOtherText) {
  Health health;
  EXPECT_FALSE(ValueTraits<Health>::Parse("fine", health));
  EXPECT_FALSE(ValueTraits<Health>::Parse("0\nBAD\tnode\t/a\t/a\t", health));
}

}  // namespace
}  // namespace coppice::leaves
