// Leaves for the charging station, and the interface that they need of a robot.
#ifndef COPPICE_BT_NODES_DOCKING_DOCKING_LEAVES_H_
#define COPPICE_BT_NODES_DOCKING_DOCKING_LEAVES_H_

#include "bt_nodes/basics/capability_action.h"

namespace coppice {

/// Called on the ticking thread; returns at once. The end is reported through the sender, from any
/// thread.
class ChargingStation {
 public:
  virtual ~ChargingStation() = default;
  /// Drives onto the station from the pose in front of it, `lateral_offset` [m] to the left of its
  /// axis. Succeeds only when current flows; fails after so many `attempts`.
  virtual void Dock(double lateral_offset, int attempts, Sender<ActionResult> done) = 0;
  /// Stands on the station without current: presses on and draws back a little until it flows.
  virtual void PressOn(Sender<ActionResult> done) = 0;
  /// Drives off the station backwards.
  virtual void Undock(Sender<ActionResult> done) = 0;
  virtual void CancelDocking() = 0;
};

class Dock : public CapabilityAction {
 public:
  static constexpr const char* kDescription =
      "Drives onto the charging station; succeeds when current flows.";
  explicit Dock(ChargingStation& station) : station_(station) {}
  Input<double> lateral_offset{this, "lateral_offset",
                               "of the approach, positive to the left when driving in [m]", 0};
  Input<int> attempts{this, "attempts", "before it fails", 1};

 protected:
  void Begin(Sender<ActionResult> done) override {
    station_.Dock(*lateral_offset, *attempts, done);
  }
  void Cancel() override { station_.CancelDocking(); }

 private:
  ChargingStation& station_;
};

class PressOn : public CapabilityAction {
 public:
  static constexpr const char* kDescription =
      "On the charging station without current: moves some centimetres on and back until current "
      "flows; fails if none does.";
  explicit PressOn(ChargingStation& station) : station_(station) {}

 protected:
  void Begin(Sender<ActionResult> done) override { station_.PressOn(done); }
  void Cancel() override { station_.CancelDocking(); }

 private:
  ChargingStation& station_;
};

class Undock : public CapabilityAction {
 public:
  static constexpr const char* kDescription = "Drives off the charging station.";
  explicit Undock(ChargingStation& station) : station_(station) {}

 protected:
  void Begin(Sender<ActionResult> done) override { station_.Undock(done); }
  void Cancel() override { station_.CancelDocking(); }

 private:
  ChargingStation& station_;
};

}  // namespace coppice

#endif  // COPPICE_BT_NODES_DOCKING_DOCKING_LEAVES_H_
