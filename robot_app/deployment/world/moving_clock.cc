#include "robot_app/deployment/world/moving_clock.h"

#include <algorithm>
#include <utility>

namespace coppice::robot::deployment {

double MovingClock::seconds() const {
  return counted_ + (is_moving_ ? SecondsOf({since_, world_.now()}) : 0);
}

void MovingClock::After(double seconds, std::function<void()> event) {
  alarms_.push_back({this->seconds() + seconds, std::move(event)});
  Plan();
}

void MovingClock::SetMoving(bool is_moving) {
  if (is_moving == is_moving_) return;
  counted_ = seconds();
  since_ = world_.now();
  is_moving_ = is_moving;
  Plan();
}

void MovingClock::Plan() {
  world_.events.Cancel(planned_);
  if (!is_moving_ || alarms_.empty()) return;
  const auto next = std::min_element(alarms_.begin(), alarms_.end(),
                                     [](const Alarm& a, const Alarm& b) { return a.at < b.at; });
  planned_ = world_.After(std::max(0.0, next->at - seconds()), [this] { Ring(); });
}

void MovingClock::Ring() {
  // Rounding may let it ring a nanosecond early.
  const double now = seconds() + 1e-6;
  const auto due =
      std::find_if(alarms_.begin(), alarms_.end(), [&](const Alarm& a) { return a.at <= now; });
  if (due == alarms_.end()) return Plan();
  const std::function<void()> event = std::move(due->event);
  alarms_.erase(due);
  event();
  Plan();
}

}  // namespace coppice::robot::deployment
