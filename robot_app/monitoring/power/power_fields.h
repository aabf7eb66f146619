// What is watched about the robot's energy, read from YAML. Each function takes the mapping of one
// section and finishes it.
#ifndef COPPICE_ROBOT_APP_MONITORING_POWER_POWER_FIELDS_H_
#define COPPICE_ROBOT_APP_MONITORING_POWER_POWER_FIELDS_H_

#include "robot_app/common/yaml_fields.h"
#include "robot_app/monitoring/power/power_watch.h"

namespace coppice::robot::monitoring {

BatteryLimits ReadBatteryLimits(YamlFields& fields);
/// The home of a site: {x: , y: } or {places: FILE}, relative to the file that is read.
DockPlace ReadDock(YamlFields& fields);
ChargingWatch ReadChargingWatch(YamlFields& fields);
DockingWatch ReadDockingWatch(YamlFields& fields);
EmergencyStopWatch ReadEmergencyStopWatch(YamlFields& fields);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_POWER_POWER_FIELDS_H_
