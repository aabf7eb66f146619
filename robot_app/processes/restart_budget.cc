#include "robot_app/processes/restart_budget.h"

#include <algorithm>
#include <utility>

namespace coppice::robot::processes {
namespace {

constexpr Duration kHour = std::chrono::hours(1);

}  // namespace

std::string SecondsText(Duration duration) {
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(duration).count();
  std::string text = std::to_string(ms / 1000);
  if (ms % 1000 != 0) text += "." + std::to_string(ms % 1000 / 100);
  return text + " s";
}

void RestartBudget::SetReady(bool ready, Time now) {
  if (!ready) {
    Prune(now);  // what the time of health until now has earned
    ready_since_.reset();
  } else if (!ready_since_) {
    ready_since_ = now;
  }
}

bool RestartBudget::IsHealthy(Time now) const {
  return ready_since_ && now - *ready_since_ >= limits_.healthy_after;
}

void RestartBudget::Prune(Time now) {
  if (IsHealthy(now)) {
    while (forgotten_ < times_.size() && times_[forgotten_] <= now - limits_.window) ++forgotten_;
  }
  while (forgotten_ > 0 && times_.front() <= now - kHour) {
    times_.erase(times_.begin());
    --forgotten_;
  }
}

int RestartBudget::Used(Time now) {
  Prune(now);
  return static_cast<int>(counting());
}

Outcome RestartBudget::Check(Time now) {
  if (Used(now) >= limits_.restarts) {
    return Problem{"restarted " + std::to_string(counting()) + " times without being healthy for " +
                   SecondsText(limits_.healthy_after) + " in between"};
  }
  const auto in_last_hour =
      std::count_if(times_.begin(), times_.end(), [now](Time time) { return time > now - kHour; });
  if (in_last_hour >= limits_.hourly) {
    return Problem{"restarted " + std::to_string(in_last_hour) + " times within an hour"};
  }
  return {};
}

void RestartBudget::Add(Time now) {
  Prune(now);
  times_.push_back(now);
}

void RestartBudget::Clear() {
  times_.clear();
  forgotten_ = 0;
}

Duration RestartBudget::Delay(const BackOff& back_off, Time now) {
  Duration delay = Duration::zero();
  for (int i = 0; i < Used(now); ++i) {
    delay = i == 0 ? back_off.first : std::min(2 * delay, back_off.most);
  }
  return delay;
}

void RestartBudget::Restore(std::vector<Time> times, std::size_t counting) {
  times_ = std::move(times);
  forgotten_ = times_.size() - std::min(counting, times_.size());
}

}  // namespace coppice::robot::processes
