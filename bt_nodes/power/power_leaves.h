// Conditions on the battery. Their inputs are fed from outside: the robot writes the keys
// battery_level and charging.
#ifndef COPPICE_BT_NODES_POWER_POWER_LEAVES_H_
#define COPPICE_BT_NODES_POWER_POWER_LEAVES_H_

#include "bt_core/nodes/leaf.h"

namespace coppice {

class IsBatteryLow : public Condition {
 public:
  static constexpr const char* kDescription = "Is the battery's state of charge below a threshold?";
  Input<double> level{this, "level", "state of charge, 0..1"};
  Input<double> threshold{this, "threshold", "low below this, 0..1", 0.3};
  bool Check() override { return *level < *threshold; }
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

class WaitForBattery : public Action {
 public:
  static constexpr const char* kDescription = "Waits until the state of the battery is known.";
  Input<bool> charging{this, "charging", "true while current flows", kOptional};
  Status OnStart() override { return OnRunning(); }
  Status OnRunning() override { return charging.has_value() ? Status::kSuccess : Status::kRunning; }
  void OnHalted() override {}
};

/// Runs until the battery is charged. Fails when the current stops before that.
class Charge : public Action {
 public:
  static constexpr const char* kDescription =
      "Waits until the battery is charged; fails if the current stops flowing.";
  Input<double> level{this, "level", "state of charge, 0..1"};
  Input<bool> charging{this, "charging", "true while current flows"};
  Input<double> until{this, "until", "charged at this level, 0..1", 0.95};

  Status OnStart() override { return OnRunning(); }
  Status OnRunning() override {
    if (*level >= *until) return Status::kSuccess;
    return *charging ? Status::kRunning : Fail("on the station, but no current flows");
  }
  void OnHalted() override {}
};

}  // namespace coppice

#endif  // COPPICE_BT_NODES_POWER_POWER_LEAVES_H_
