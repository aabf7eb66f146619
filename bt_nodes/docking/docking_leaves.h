// Leaves for the charging station, and the interface that they need of a robot.
#ifndef COPPICE_BT_NODES_DOCKING_DOCKING_LEAVES_H_
#define COPPICE_BT_NODES_DOCKING_DOCKING_LEAVES_H_

#include "bt_nodes/system/capability_action.h"

namespace coppice {

/// Called on the ticking thread; returns at once. The end is reported through the sender, from any
/// thread.
class ChargingStation {
 public:
  virtual ~ChargingStation() = default;
  /// Drives onto the station from the pose in front of it. Succeeds only when current flows.
  virtual void Dock(Sender<ActionResult> done) = 0;
  /// Drives off the station backwards.
  virtual void Undock(Sender<ActionResult> done) = 0;
  virtual void CancelDocking() = 0;
};

class Dock : public CapabilityAction {
 public:
  static constexpr const char* kDescription =
      "Drives onto the charging station; succeeds when current flows.";
  explicit Dock(ChargingStation& station) : station_(station) {}

 protected:
  void Begin(Sender<ActionResult> done) override { station_.Dock(done); }
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
