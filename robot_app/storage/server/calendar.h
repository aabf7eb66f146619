// Moments as databases and file names have them, in UTC.
#ifndef COPPICE_ROBOT_APP_STORAGE_SERVER_CALENDAR_H_
#define COPPICE_ROBOT_APP_STORAGE_SERVER_CALENDAR_H_

#include <cstdint>
#include <string>

namespace coppice::robot::storage {

/// Of nanoseconds since 1970: "2026-11-25 08:30:00.123456+00".
std::string MomentText(std::int64_t nanoseconds);

/// The day that it lies in: "2026-11-25". `days` later.
std::string DayText(std::int64_t nanoseconds, int days = 0);

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_SERVER_CALENDAR_H_
