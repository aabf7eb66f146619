// Leaves for the charging station: Dock, PressOn, Undock.
#ifndef COPPICE_BT_NODES_DOCKING_DOCKING_LEAVES_H_
#define COPPICE_BT_NODES_DOCKING_DOCKING_LEAVES_H_

#include "bt_nodes/basics/capability_action.h"
#include "bt_nodes/docking/charging_station.h"

namespace coppice::leaves {

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
  Turn* turn() override { return &station_.turn; }

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
  Turn* turn() override { return &station_.turn; }

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
  Turn* turn() override { return &station_.turn; }

 private:
  ChargingStation& station_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_DOCKING_DOCKING_LEAVES_H_
