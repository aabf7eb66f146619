// How the monitor tree and the application tree of one robot speak with each other: through keys of
// the other's blackboard, and by suspending it.
#ifndef COPPICE_ROBOT_APP_APP_TREE_LINK_H_
#define COPPICE_ROBOT_APP_APP_TREE_LINK_H_

#include "bt_nodes/application/application_control.h"
#include "robot_app/app/tree_runner.h"

namespace coppice::robot {

/// Writes the key charge_requested of the application and going_home of the monitor tree. Without
/// effect until both are connected. Any thread after that.
class TreeLink : public leaves::ApplicationControl {
 public:
  /// Before the trees run; both must live as long as they run.
  void Connect(TreeRunner& application, TreeRunner& monitor);

  void SetChargeRequested(bool requested) override { charge_requested_.Send(requested); }
  void SetGoingHome(bool going_home) override { going_home_.Send(going_home); }
  void Suspend() override;
  void Resume() override;

 private:
  TreeRunner* application_ = nullptr;
  Sender<bool> charge_requested_;
  Sender<bool> going_home_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_APP_TREE_LINK_H_
