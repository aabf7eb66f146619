#include "robot_app/simulation/battery.h"

#include <algorithm>

namespace coppice::robot::simulation {

Battery::Battery(const BatteryOptions& options, double state_of_charge) : options_(options) {
  set_state_of_charge(state_of_charge);
}

void Battery::set_state_of_charge(double state_of_charge) {
  charge_ = std::clamp(state_of_charge, 0.0, 1.0) * options_.capacity;
}

void Battery::Step(double dt, double effort, bool contact, double climbing) {
  if (contact) {
    // The charger feeds the standing robot too; a full battery takes nothing more.
    current_ = full() ? 0 : options_.charging_current;
  } else if (empty()) {
    current_ = 0;
  } else if (effort > 0) {
    current_ = -(options_.slow_current +
                 std::min(effort, 1.0) * (options_.fast_current - options_.slow_current) +
                 climbing / options_.efficiency / options_.empty_voltage);
  } else {
    current_ = -options_.standby_current;
  }
  charge_ = std::clamp(charge_ + current_ * dt / 3600, 0.0, options_.capacity);
}

double Battery::voltage() const {
  return options_.empty_voltage +
         state_of_charge() * (options_.full_voltage - options_.empty_voltage) +
         current_ * options_.resistance;
}

}  // namespace coppice::robot::simulation
