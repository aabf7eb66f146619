// Leaves and decorators with which the monitor tree and the application tree speak to each other.
#ifndef COPPICE_BT_NODES_APPLICATION_APPLICATION_LEAVES_H_
#define COPPICE_BT_NODES_APPLICATION_APPLICATION_LEAVES_H_

#include "bt_core/nodes/user_control.h"
#include "bt_nodes/application/application_control.h"

namespace coppice::leaves {

/// A state with a heartbeat: said again now and then, so that an application that was restarted
/// hears of it.
class RequestCharge : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Tells the application whether it must go and charge. Does not wait for it.";
  explicit RequestCharge(ApplicationControl& application) : application_(application) {}
  Input<bool> requested{this, "requested", "true: go and charge"};
  Input<double> period{this, "period", "says it again so often [s]", 5};
  Status Run() override;

 private:
  ApplicationControl& application_;
  bool was_requested_ = false;
  bool has_said_ = false;
  Time said_at_{};
};

/// Around what brings the robot to the station and charges it.
class AnnounceGoingHome : public UserDecorator {
 public:
  static constexpr const char* kDescription =
      "Tells the battery watchdog that the application is on its way to the station as long as the "
      "child is active. The result is the child's.";
  explicit AnnounceGoingHome(ApplicationControl& application) : application_(application) {}
  Status Tick(Children& child, bool starting) override;
  void OnHalted() override { application_.SetGoingHome(false); }

 private:
  ApplicationControl& application_;
};

/// Around what must have the robot for itself.
class SuspendApplication : public UserDecorator {
 public:
  static constexpr const char* kDescription =
      "Halts the application as long as the child is active; then it begins anew. The result is "
      "the child's.";
  explicit SuspendApplication(ApplicationControl& application) : application_(application) {}
  Status Tick(Children& child, bool starting) override;
  void OnHalted() override { application_.Resume(); }

 private:
  ApplicationControl& application_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_APPLICATION_APPLICATION_LEAVES_H_
