// Leaves and decorators with which the monitor tree and the application tree speak to each other.
#ifndef COPPICE_BT_NODES_APPLICATION_APPLICATION_LEAVES_H_
#define COPPICE_BT_NODES_APPLICATION_APPLICATION_LEAVES_H_

#include <memory>
#include <utility>

#include "bt_core/nodes/user_control.h"
#include "bt_nodes/application/application_control.h"

namespace coppice::leaves {

class IsOffDuty : public Condition {
 public:
  static constexpr const char* kDescription =
      "Are these no working hours? A robot that was not told its hours is always on duty.";
  Input<double> duty_left{this, "duty_left",
                          "until the end of the working hours, fed from outside [s]", kOptional};
  bool Check() override { return duty_left.has_value() && *duty_left <= 0; }
};

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

/// Around what brings the robot to the station and charges it. Of several in one tree one may begin
/// before another is halted in the same tick; the robot goes home as long as one of them is active.
class AnnounceGoingHome : public UserDecorator {
 public:
  static constexpr const char* kDescription =
      "Tells the battery watchdog that the application is on its way to the station as long as the "
      "child is active. The result is the child's.";
  /// `active`: how many are, shared by those of one tree.
  explicit AnnounceGoingHome(ApplicationControl& application,
                             std::shared_ptr<int> active = std::make_shared<int>(0))
      : application_(application), active_(std::move(active)) {}
  Status Tick(Children& child, bool starting) override;
  void OnHalted() override { End(); }

 private:
  void End() {
    if (--*active_ == 0) application_.SetGoingHome(false);
  }

  ApplicationControl& application_;
  std::shared_ptr<int> active_;
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
