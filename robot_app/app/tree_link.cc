#include "robot_app/app/tree_link.h"

namespace coppice::robot {

void TreeLink::Connect(TreeRunner& application, TreeRunner& monitor) {
  application_ = &application;
  charge_requested_ = application.executor().Writer<bool>("charge_requested");
  going_home_ = monitor.executor().Writer<bool>("going_home");
  charge_requested_.Send(false);
  going_home_.Send(false);
}

void TreeLink::Suspend() {
  if (application_) application_->Suspend();
}

void TreeLink::Resume() {
  if (application_) application_->Resume();
}

}  // namespace coppice::robot
