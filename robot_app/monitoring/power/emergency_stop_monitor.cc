#include "robot_app/monitoring/power/emergency_stop_monitor.h"

namespace coppice::robot {
namespace {

double InSeconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

void EmergencyStopMonitor::Watch(const std::optional<EmergencyStopWatch>& watch) {
  if (!watch || !watch_ || watch->topic != watch_->topic) {
    pressed_at_.reset();
    heard_at_.reset();
  }
  watch_ = watch;
}

void EmergencyStopMonitor::OnState(bool is_pressed, Time now) {
  heard_at_ = now;
  if (!is_pressed) pressed_at_.reset();
  if (is_pressed && !pressed_at_) pressed_at_ = now;
}

std::vector<Finding> EmergencyStopMonitor::Report(const Times& now) {
  if (!watch_) return {};
  if (!heard_at_ || now.ros < *heard_at_) heard_at_ = now.ros;
  Finding finding{"emergency_stop", "button", "", HealthLevel::kOk, 0, "s", "", now.ros};
  if (pressed_at_) {
    finding.level = HealthLevel::kError;
    finding.value = InSeconds(now.ros - *pressed_at_);
    finding.message = "pressed for " + ToText(finding.value) + " s";
    return {finding};
  }
  const Duration silence = now.ros - *heard_at_;
  if (watch_->staleness > Duration::zero() && silence > watch_->staleness) {
    finding.level = HealthLevel::kError;
    finding.message = watch_->topic + ": no message for " + ToText(InSeconds(silence)) + " s";
  }
  freshness_.Apply(finding, now.wall, patience_);
  return {finding};
}

}  // namespace coppice::robot
