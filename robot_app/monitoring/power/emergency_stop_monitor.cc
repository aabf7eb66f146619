#include "robot_app/monitoring/power/emergency_stop_monitor.h"

#include "robot_app/monitoring/gauges/band.h"

namespace coppice::robot::monitoring {

void EmergencyStopMonitor::Watch(const std::optional<EmergencyStopWatch>& watch) {
  if (!watch || !watch_ || watch->topic != watch_->topic) {
    pressed_at_.reset();
    freshness_.Reset();
  }
  watch_ = watch;
}

void EmergencyStopMonitor::OnState(bool is_pressed, const Times& now) {
  freshness_.OnMessage(now);
  if (!is_pressed) pressed_at_.reset();
  if (is_pressed && !pressed_at_) pressed_at_ = now.ros;
}

std::vector<Finding> EmergencyStopMonitor::Report(const ProcessTable& processes, const Times& now) {
  if (!watch_) return {};
  const bool may_be_silent = watch_->staleness == Duration::zero();
  Finding button = freshness_.Assess({"emergency_stop", "button", ""},
                                     may_be_silent ? Duration::max() : watch_->staleness,
                                     watch_->topic + ": no message", processes, now);
  button.value = 0;
  if (pressed_at_) {
    button.level = leaves::HealthLevel::kError;
    button.value = InSeconds(now.ros - *pressed_at_);
    button.message = "pressed for " + ToText(button.value) + " s";
  }
  return {button};
}

}  // namespace coppice::robot::monitoring
