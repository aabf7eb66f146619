// Supervisors at the console: the question is printed, and answered by a line on standard input or
// by a message on /supervisor/answer (std_msgs/String): "fixed" or "not fixed". The tree that asks
// sets the deadline.
#ifndef COPPICE_ROBOT_APP_ROS_CONSOLE_SUPERVISOR_H_
#define COPPICE_ROBOT_APP_ROS_CONSOLE_SUPERVISOR_H_

#include <ros/node_handle.h>
#include <std_msgs/String.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "bt_nodes/supervision/supervision_leaves.h"

namespace coppice::robot {

class ConsoleSupervisor : public SupervisorChannel {
 public:
  explicit ConsoleSupervisor(ros::NodeHandle& node);
  ~ConsoleSupervisor() override;

  void Ask(const std::string& question, Sender<ActionResult> done) override;
  void Withdraw() override;

 private:
  void ReadConsole();
  void Answer(const std::string& text);

  ros::Publisher question_;
  ros::Subscriber answer_;
  std::mutex mutex_;
  bool asking_ = false;
  Sender<ActionResult> done_;
  std::atomic<bool> stop_{false};
  std::thread reader_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_ROS_CONSOLE_SUPERVISOR_H_
