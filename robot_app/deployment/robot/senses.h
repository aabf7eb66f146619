// What monitors and trees get to know of the body: readings and states as the robot's topics would
// carry them.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_SENSES_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_SENSES_H_

#include "bt_nodes/people/people_view.h"
#include "bt_nodes/power/battery_reading.h"
#include "robot_app/deployment/world/world.h"

namespace coppice::robot::deployment {

inline leaves::BatteryReading ReadBattery(const World& world) {
  using leaves::ChargerState;
  leaves::BatteryReading reading;
  reading.stamp = world.now();
  reading.current = world.current;
  reading.level = world.battery.state_of_charge();
  reading.charge = world.battery.charge();
  // As the real one: the open voltage, and the sag of the mean current.
  const simulation::BatteryOptions options;
  reading.voltage = options.empty_voltage +
                    reading.level * (options.full_voltage - options.empty_voltage) +
                    reading.current * options.resistance;
  if (!world.docked) {
    reading.charger = ChargerState::kDischarging;
  } else if (!world.has_current) {
    reading.charger = ChargerState::kNotCharging;
  } else {
    reading.charger = world.battery.full() ? ChargerState::kFull : ChargerState::kCharging;
  }
  return reading;
}

// Who stands in the way, before the robot but too far off to be greeted.
inline leaves::PeopleView SeePeople(const World& world) {
  leaves::PeopleView view;
  view.stamp = world.now();
  if (world.hindrance == Hindrance::kPassing && world.is_noticed) {
    leaves::SeenPerson person;
    person.x = 2;
    person.known_for = 1;
    view.people = {person};
  }
  return view;
}

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_SENSES_H_
