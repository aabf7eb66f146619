// What is watched about the robot's energy, as plain values.
#ifndef COPPICE_ROBOT_APP_MONITORING_POWER_POWER_WATCH_H_
#define COPPICE_ROBOT_APP_MONITORING_POWER_POWER_WATCH_H_

#include <optional>
#include <string>

#include "bt_nodes/power/battery_estimate.h"
#include "robot_app/monitoring/gauges/band.h"

namespace coppice::robot::monitoring {

/// Where the robot charges, and how far that is.
struct DockPlace {
  double x = 0, y = 0;            ///< m
  std::string map_frame = "map";  ///< of x and y
  std::string base_frame = "base_link";
  std::string way;      ///< std_msgs/Float64: the way as navigation measures it [m]; may be empty
  double detour = 1.5;  ///< else: way there over the straight line
};

struct BatteryLimits {
  std::string topic;              ///< sensor_msgs/BatteryState
  std::string node;               ///< its publisher, to be restarted when it falls silent
  Duration staleness{0};          ///< no message for longer than this is an error
  Band voltage;                   ///< V
  Band current;                   ///< A, positive: into the battery
  Band charge;                    ///< state of charge, 0..1
  Band coulombs;                  ///< Ah, what the battery says less what its current has brought
  Band unchanged;                 ///< s that the charge has stood still although current flows
  Band since_charge;              ///< s since the last charging current
  Band margin;                    ///< Ah left after the way to the dock and the reserve
  leaves::BatteryModel model;     ///< for the way and the reserve
  std::optional<DockPlace> dock;  ///< missing: the way is not counted
};

struct ChargingWatch {
  double current = 0.5;      ///< A; less is no charging current
  Duration within{0};        ///< so soon after the contact it must flow
  Duration interruption{0};  ///< so long it may pause before the battery is full
  double full = 0.95;        ///< state of charge from which on no current needs to flow
};

struct DockingWatch {
  std::string action;     ///< name of the action server
  std::string node;       ///< its node, to be restarted when it falls silent
  Duration staleness{0};  ///< no status for longer than this is an error
  Band failures;          ///< attempts in a row that did not succeed
  Band duration;          ///< s of one attempt
  Duration forget{0};     ///< failures count no more when nobody has tried for so long
};

struct EmergencyStopWatch {
  std::string topic;      ///< std_msgs/Bool, true: pressed
  Duration staleness{0};  ///< no message for longer than this is an error; zero: silence is allowed
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_POWER_POWER_WATCH_H_
