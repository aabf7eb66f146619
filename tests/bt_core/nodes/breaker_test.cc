#include "bt_core/nodes/breaker.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

TEST(FailureTimes, ForgetsWhatIsOlderThanThePeriod) {
  FailureTimes failures;
  EXPECT_EQ(failures.Add(Time(100), Time(0)), 1U);
  EXPECT_EQ(failures.Add(Time(200), Time(100)), 2U);
  EXPECT_EQ(failures.Add(Time(300), Time(101)), 2U);
  failures.Clear();
  EXPECT_EQ(failures.Add(Time(400), Time(0)), 1U);
}

TEST(FailureTimes, ReadsWhatItPrints) {
  FailureTimes failures;
  failures.Add(Time(100), Time(0));
  failures.Add(Time(250), Time(0));
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
