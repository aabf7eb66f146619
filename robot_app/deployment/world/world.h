// What is true in the world of a deployment, apart from what the robot believes: one flat state,
// the clock, and what will happen. Everything else acts on it.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_WORLD_WORLD_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_WORLD_WORLD_H_

#include <cstdint>
#include <string>

#include "bt_core/base/clock.h"
#include "robot_app/common/pose2d.h"
#include "robot_app/deployment/figures/journal.h"
#include "robot_app/deployment/scenario/scenario.h"
#include "robot_app/deployment/world/event_queue.h"
#include "robot_app/simulation/battery.h"

namespace coppice::robot::deployment {

/// What holds the robot.
enum class Hindrance : std::uint8_t {
  kNone,
  kPassing,  ///< people: goes away by itself
  kTrap,     ///< the robot must move backwards
  kClosed,   ///< a door, a fire door or a box; other ways may be free
};

/// Why the position is lost.
enum class Loss : std::uint8_t {
  kNone,
  kTransient,  ///< to turn and look around is enough
  kInside,     ///< the localization must be started from a cleared state first
  kOutside,    ///< the building has changed: a person must tell the position
};

struct World {
  World(const Scenario& the_scenario, std::uint64_t the_seed)
      : scenario(the_scenario),
        seed(the_seed),
        clock(the_scenario.calendar.span().from.time_since_epoch()) {}
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  Time now() const { return clock.Now(); }
  EventQueue::Id After(double seconds, EventQueue::Event event) {
    return events.At(now() + Seconds(seconds), std::move(event));
  }

  const Scenario& scenario;
  const std::uint64_t seed;
  SimulatedClock clock;
  EventQueue events;
  Journal journal;

  // The body.
  simulation::Battery battery;
  double current = 0;  ///< A, mean of the last step; negative: discharging
  Pose2D pose;         ///< base_link in the map frame
  bool docked = true;
  bool has_current = true;  ///< of the contact
  bool rolls = false;       ///< the wheels take it along its way
  bool is_off = false;
  Time progress{};  ///< it last got on, or was where it should be

  // What is wrong.
  Hindrance hindrance = Hindrance::kNone;
  bool is_noticed = false;  ///< the people of kPassing, by the robot's perception
  std::string closed;       ///< the door or place
  Loss loss = Loss::kNone;
  Time lost_at{};
  bool station_is_broken = false;  ///< no attempt gets there
  bool station_has_power = true;
  bool contact_is_bad = false;        ///< this time
  bool battery_key_is_stuck = false;  ///< the application no longer hears the battery
  bool network = true;
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_WORLD_WORLD_H_
