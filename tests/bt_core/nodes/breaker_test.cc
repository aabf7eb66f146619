#include "bt_core/nodes/breaker.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

TEST(FailureTimes, ForgetsWhatIsOlderThanThePeriod) {
  FailureTimes failures;
  EXPECT_EQ(failures.Add(Time(Duration(100)), Time{}), 1U);
  EXPECT_EQ(failures.Add(Time(Duration(200)), Time(Duration(100))), 2U);
  EXPECT_EQ(failures.Add(Time(Duration(300)), Time(Duration(101))), 2U);
  failures.Clear();
  EXPECT_EQ(failures.Add(Time(Duration(400)), Time{}), 1U);
}

TEST(FailureTimes, ReadsWhatItPrints) {
  FailureTimes failures;
  failures.Add(Time(Duration(100)), Time{});
  failures.Add(Time(Duration(250)), Time{});
  const std::string text = ValueTraits<FailureTimes>::Print(failures);
  EXPECT_EQ(text, "100;250");
  FailureTimes read;
  ASSERT_TRUE(ValueTraits<FailureTimes>::Parse(text, read));
  EXPECT_EQ(ValueTraits<FailureTimes>::Print(read), text);
  EXPECT_TRUE(ValueTraits<FailureTimes>::Parse("", read));
  EXPECT_FALSE(ValueTraits<FailureTimes>::Parse("250;100", read));
  EXPECT_FALSE(ValueTraits<FailureTimes>::Parse("1;x", read));
}

}  // namespace
}  // namespace coppice
