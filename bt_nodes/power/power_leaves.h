// Conditions on the battery. Their inputs are fed from outside: the robot writes the keys
// battery_level, charging and docked, and battery and distance_to_station for the watchdog.
//
// A level that is not known is negative, and counts as low: a robot that cannot read its battery
// goes home, and stays on its station until the charger says that the battery is full. Whether it
// stands there is a fact of its own: a full battery draws no current.
#ifndef COPPICE_BT_NODES_POWER_POWER_LEAVES_H_
#define COPPICE_BT_NODES_POWER_POWER_LEAVES_H_

#include <memory>
#include <string>

#include "bt_core/nodes/leaf.h"
#include "bt_nodes/power/battery_watch.h"

namespace coppice::leaves {

class IsBatteryLow : public Condition {
 public:
  static constexpr const char* kDescription = "Is the battery's state of charge below a threshold?";
  Input<double> level{this, "level", "state of charge, 0..1; negative: not known, counts as low"};
  Input<double> threshold{this, "threshold", "low below this, 0..1", 0.3};
  bool Check() override { return !(*level >= *threshold); }  // NaN, too, is low
};

class IsCharging : public Condition {
 public:
  static constexpr const char* kDescription = "Does charging current flow into the battery?";
  Input<bool> charging{this, "charging", "true while current flows"};
  bool Check() override { return *charging; }
};

/// Not the inverse of IsCharging: as long as nothing is known, both fail.
class IsNotCharging : public Condition {
 public:
  static constexpr const char* kDescription = "Is it known that no charging current flows?";
  Input<bool> charging{this, "charging", "true while current flows"};
  bool Check() override { return !*charging; }
};

class IsDocked : public Condition {
 public:
  static constexpr const char* kDescription =
      "Does the robot stand on its charging station, with or without current?";
  Input<bool> docked{this, "docked", "true while the station's contacts touch"};
  bool Check() override { return *docked; }
};

/// Not the inverse of IsDocked: as long as nothing is known, both fail.
class IsNotDocked : public Condition {
 public:
  static constexpr const char* kDescription =
      "Is it known that the robot does not stand on its charging station?";
  Input<bool> docked{this, "docked", "true while the station's contacts touch"};
  bool Check() override { return !*docked; }
};

class WaitForBattery : public Action {
 public:
  static constexpr const char* kDescription =
      "Waits until it is known whether the robot stands on its charging station.";
  Input<bool> docked{this, "docked", "true while the station's contacts touch", kOptional};
  Status OnStart() override { return OnRunning(); }
  Status OnRunning() override { return docked.has_value() ? Status::kSuccess : Status::kRunning; }
  void OnHalted() override {}
};

/// Runs until the battery is charged. Fails when the current stops before that. A level that is not
/// known is not charged; what a charger calls full has the level 1.
class Charge : public Action {
 public:
  static constexpr const char* kDescription =
      "Waits until the battery is charged; fails if the current stops flowing.";
  Input<double> level{this, "level", "state of charge, 0..1; negative: not known"};
  Input<bool> charging{this, "charging", "true while current flows"};
  Input<double> until{this, "until", "charged at this level, 0..1", 0.95};

  Status OnStart() override { return OnRunning(); }
  Status OnRunning() override {
    if (*level >= *until) return Status::kSuccess;
    return *charging ? Status::kRunning : Fail("on the station, but no current flows");
  }
  void OnHalted() override {}
};

/// How long to charge, and from when on. Where the hours are known in which the robot works, it
/// charges as much as it needs for the rest of them, and no sooner than it must: all else can be
/// charged at night, when it costs nothing. The reserve at the end of the day is untouched.
class PlanCharge : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Works out when the battery counts as low, and how far to charge it: for the rest of the "
      "working hours, as far as those are known.";
  Input<double> duty_left{this, "duty_left",
                          "until the end of the working hours, fed from outside [s]; not fed: the "
                          "robot works at any time",
                          kOptional};
  Input<bool> requested{this, "requested", "the battery watchdog wants it to charge", kOptional};
  Input<double> when_requested{
      this, "when_requested", "then it is charged at least so far, 0..1: more than ChargeDue wants",
      0.4};
  Input<double> capacity{this, "capacity", "of the battery [Ah]", 75};
  Input<double> current{this, "current", "drawn at work, on the average [A]", 11};
  Input<double> reserve{this, "reserve", "left at the end of the working hours, 0..1", 0.15};
  Input<double> slack{this, "slack", "so much less than planned is no reason to go, 0..1", 0.05};
  Input<double> low{this, "low",
                    "with less it goes in any case but towards the end of the day, 0..1", 0.5};
  Output<double> low_below{this, "low_below", "low below this level, 0..1"};
  Output<double> until{this, "until", "charged at this level, 0..1"};
  Status Run() override;
};

/// The decision of the battery watchdog. To be ticked all the time: it counts the current.
class ChargeDue : public Condition {
 public:
  static constexpr const char* kDescription =
      "Must the robot go and charge? Judged from the battery's raw readings alone; once it is so, "
      "it stays so until the battery has been charged.";
  Input<BatteryReading> battery{this, "battery", "newest reading, fed from outside", kOptional};
  Input<double> distance{this, "distance", "of the path to the station, fed from outside [m]",
                         kOptional};
  Input<double> capacity{this, "capacity", "of the battery [Ah]", 75};
  Input<double> full_voltage{this, "full_voltage", "without load, charged [V]", 25.4};
  Input<double> empty_voltage{this, "empty_voltage", "without load, empty [V]", 23.0};
  Input<double> driving_current{this, "driving_current", "drawn while driving [A]", 15};
  Input<double> driving_speed{this, "driving_speed", "mean on the way home [m/s]", 0.28};
  Input<double> longest_without_charge{this, "longest_without_charge",
                                       "then it is due in any case [s]", 14400};
  Input<double> longest_silence{this, "longest_silence",
                                "of the battery; then it is due in any case [s]", 60};
  Input<double> last_charge{this, "last_charge",
                            "no more, or no more than the way takes: exhausted [Ah]", 1.5};
  Input<double> charged{this, "charged",
                        "settled at this level, when it has charged for ten minutes", 0.9};
  Output<std::string> reason{this, "reason", "why it is due, for people"};
  Output<bool> critical{this, "critical", "the robot may not reach the station without help"};
  Output<bool> exhausted{this, "exhausted", "the robot will not reach the station any more"};
  bool Check() override;

 private:
  std::unique_ptr<BatteryWatch> watch_;  // from the first tick on, when the ports can be read
  BatteryVerdict told_;                  // what stands on the blackboard
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_POWER_POWER_LEAVES_H_
