#include "robot_app/teleoperation/velocity_mux.h"

namespace coppice::robot::teleoperation {

VelocityMux::VelocityMux(std::vector<Duration> timeouts) {
  for (const Duration timeout : timeouts) sources_.push_back({timeout, Time{}});
}

bool VelocityMux::Offer(std::size_t source, const Velocity2D& command, Time now) {
  const std::optional<std::size_t> holder = active(now);
  sources_[source].counts_until = now + sources_[source].timeout;
  if (holder && *holder < source) return false;
  last_ = source;
  moves_ = command.linear != 0 || command.angular != 0;
  return true;
}

bool VelocityMux::MustStop(Time now) {
  if (!moves_ || now < sources_[last_].counts_until) return false;
  moves_ = false;
  return true;
}

std::optional<std::size_t> VelocityMux::active(Time now) const {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (now < sources_[i].counts_until) return i;
  }
  return std::nullopt;
}

}  // namespace coppice::robot::teleoperation
