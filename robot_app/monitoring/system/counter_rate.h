// How fast a counter of the operating system grows: over a window that slides.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_COUNTER_RATE_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_COUNTER_RATE_H_

#include <deque>
#include <optional>

#include "bt_core/base/clock.h"

namespace coppice::robot::monitoring {

class CounterRate {
 public:
  explicit CounterRate(Duration window) : window_(window) {}

  /// Per second, between the oldest reading within the window and this one; nothing for the first
  /// reading and for one that is lower than the one before (the counter has begun anew).
  std::optional<double> OnReading(double reading, Time now) {
    const bool anew =
        !readings_.empty() && (reading < readings_.back().value || now < readings_.back().time);
    if (anew) readings_.clear();
    while (readings_.size() > 1 && readings_[1].time <= now - window_) readings_.pop_front();
    readings_.push_back({reading, now});
    const double seconds = std::chrono::duration<double>(now - readings_.front().time).count();
    if (seconds <= 0) return std::nullopt;
    return (reading - readings_.front().value) / seconds;
  }

 private:
  struct Reading {
    double value;
    Time time;
  };
  Duration window_;
  std::deque<Reading> readings_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_COUNTER_RATE_H_
