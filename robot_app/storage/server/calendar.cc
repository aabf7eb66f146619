#include "robot_app/storage/server/calendar.h"

#include <array>
#include <cstdio>
#include <ctime>

namespace coppice::robot::storage {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kDay = 24 * 3600;  // s

// Rounded down, before 1970 too.
std::int64_t SecondsOf(std::int64_t nanoseconds) {
  return nanoseconds / kSecond - (nanoseconds % kSecond < 0 ? 1 : 0);
}

std::string Format(const char* format, std::int64_t seconds) {
  const std::time_t time = seconds;
  std::tm parts{};
  gmtime_r(&time, &parts);
  std::array<char, 40> text{};
  return {text.data(), std::strftime(text.data(), text.size(), format, &parts)};
}

}  // namespace

std::string MomentText(std::int64_t nanoseconds) {
  const std::int64_t seconds = SecondsOf(nanoseconds);
  std::array<char, 16> fraction{};
  std::snprintf(fraction.data(), fraction.size(), ".%06d+00",
                static_cast<int>((nanoseconds - seconds * kSecond) / 1000));
  return Format("%F %T", seconds) + fraction.data();
}

std::string DayText(std::int64_t nanoseconds, int days) {
  return Format("%F", SecondsOf(nanoseconds) + days * kDay);
}

}  // namespace coppice::robot::storage
