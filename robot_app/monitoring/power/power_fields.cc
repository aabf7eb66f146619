#include "robot_app/monitoring/power/power_fields.h"

#include <filesystem>

#include "robot_app/common/places/station_place.h"
#include "robot_app/monitoring/gauges/band_fields.h"

namespace coppice::robot::monitoring {
namespace {

constexpr double kHour = 3600;

leaves::BatteryModel ReadModel(YamlFields& fields) {
  leaves::BatteryModel model;
  model.capacity = fields.Number("capacity", model.capacity, 0.1, 10000);
  model.driving_current = fields.Number("driving_current", model.driving_current, 0.01, 1000);
  model.driving_speed = fields.Number("driving_speed", model.driving_speed, 0.01, 10);
  model.charging_above = fields.Number("charging_above", model.charging_above, 0.001, 1000);
  model.docking_attempts = fields.Integer("docking_attempts", model.docking_attempts, 1, 100);
  model.attempt_time = fields.Number("attempt_time", model.attempt_time, 0, kHour);
  model.help_time = fields.Number("help_time", model.help_time, 0, 24 * kHour);
  fields.Finish();
  return model;
}

// The home in a file of places, whose name is relative to the file that is read.
Pose2D ReadHomeOf(YamlFields& fields) {
  const LocatedText places = fields.Text("places");
  const auto file = std::filesystem::path(places.where.file).parent_path() / places.text;
  Diagnostics problems;
  const auto home = HomeIn(file.string(), problems);
  if (!home) {
    fields.Error(places.where, problems.has_errors()
                                   ? problems.ToString()
                                   : file.string() +
                                         " has no place of the category \"station\" or "
                                         "\"meeting_point\"");
  }
  return home.value_or(Pose2D());
}

}  // namespace

DockPlace ReadDock(YamlFields& fields) {
  DockPlace dock;
  if (fields.Has("places")) {
    const Pose2D home = ReadHomeOf(fields);
    dock.x = home.x;
    dock.y = home.y;
  } else {
    dock.x = fields.Number("x", 0, -1e6, 1e6);
    dock.y = fields.Number("y", 0, -1e6, 1e6);
  }
  dock.map_frame = fields.Text("map_frame", dock.map_frame).text;
  dock.base_frame = fields.Text("base_frame", dock.base_frame).text;
  dock.way = fields.Has("way") ? ReadRosName(fields, "way") : "";
  dock.detour = fields.Number("detour", dock.detour, 1, 100);
  fields.Finish();
  return dock;
}

BatteryLimits ReadBatteryLimits(YamlFields& fields) {
  BatteryLimits watch;
  watch.topic = ReadRosName(fields, "topic");
  watch.node = ReadRosName(fields, "node");
  watch.staleness = fields.Seconds("staleness", 5, 0.1, kHour);
  watch.voltage = ReadBand(fields, "voltage");  // depends on the cells
  watch.current = ReadBand(fields, "current");  // depends on the motors and the charger
  watch.charge = ReadBand(fields, "charge", AtLeast(0.25, 0.15, 3, 0.01));
  watch.coulombs = ReadBand(fields, "coulombs", {{-2, 2}, {}, 3, Duration::zero(), 0});
  watch.unchanged = ReadBand(fields, "unchanged", AtMost(60, 180));
  watch.since_charge = ReadBand(fields, "since_charge", AtMost(3.5 * kHour, 4 * kHour));
  watch.margin = ReadBand(fields, "margin", AtLeast(3, 0, 3, 0.1));
  YamlFields model = fields.Map("model");
  watch.model = ReadModel(model);
  const bool has_dock = fields.Has("dock");
  YamlFields dock = fields.Map("dock");
  if (has_dock) watch.dock = ReadDock(dock);
  fields.Finish();
  return watch;
}

ChargingWatch ReadChargingWatch(YamlFields& fields) {
  ChargingWatch watch;
  watch.current = fields.Number("current", 0.5, 0.01, 1000);
  watch.within = fields.Seconds("within", 12, 0.1, kHour);
  watch.interruption = fields.Seconds("interruption", 5, 0.1, kHour);
  watch.full = fields.Number("full", 0.95, 0, 1);
  fields.Finish();
  return watch;
}

DockingWatch ReadDockingWatch(YamlFields& fields) {
  DockingWatch watch;
  watch.action = ReadRosName(fields, "action");
  watch.node = ReadRosName(fields, "node");
  watch.staleness = fields.Seconds("staleness", 5, 0.1, kHour);
  watch.failures = ReadBand(fields, "failures", AtMost(0, 2));
  watch.duration = ReadBand(fields, "duration", AtMost(180, 300));
  watch.forget = fields.Seconds("forget", 600, 0, 24 * kHour);
  fields.Finish();
  return watch;
}

EmergencyStopWatch ReadEmergencyStopWatch(YamlFields& fields) {
  EmergencyStopWatch watch;
  watch.topic = ReadRosName(fields, "topic");
  watch.staleness = fields.Seconds("staleness", 0, 0, kHour);
  fields.Finish();
  return watch;
}

}  // namespace coppice::robot::monitoring
