#include "robot_app/storage/server/calendar.h"

#include <gtest/gtest.h>

namespace coppice::robot::storage {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

TEST(MomentText, IsInUtcWithMicrosecondsRoundedDown) {
  EXPECT_EQ(MomentText(0), "1970-01-01 00:00:00.000000+00");
  EXPECT_EQ(MomentText(1764059400 * kSecond + 123'456'999), "2025-11-25 08:30:00.123456+00");
  EXPECT_EQ(MomentText(-1), "1969-12-31 23:59:59.999999+00");
}

TEST(DayText, IsTheDayInUtc) {
  EXPECT_EQ(DayText(24 * 3600 * kSecond - 1), "1970-01-01");
  EXPECT_EQ(DayText(24 * 3600 * kSecond), "1970-01-02");
  EXPECT_EQ(DayText(1735660800 * kSecond, 1), "2025-01-01");
}

}  // namespace
}  // namespace coppice::robot::storage
