// Supervisors at the console: a question is printed, and answered by a line on standard input or
// by a message on /supervisor/answer (std_msgs/String): "fixed" or "not fixed". Of several open
// questions the answer is to the newest. The tree that asks sets the deadline.
#ifndef COPPICE_ROBOT_APP_ROS_CONSOLE_SUPERVISOR_H_
#define COPPICE_ROBOT_APP_ROS_CONSOLE_SUPERVISOR_H_

#include <ros/node_handle.h>
#include <std_msgs/String.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "bt_nodes/supervision/supervision_leaves.h"

namespace coppice::robot {

class ConsoleSupervisor : public SupervisorChannel {
 public:
  explicit ConsoleSupervisor(ros::NodeHandle& node);
  ~ConsoleSupervisor() override;

  void Ask(const std::string& subject, const std::string& question,
           Sender<ActionResult> done) override;
  void Withdraw(const std::string& subject) override;
  void Tell(const std::string& subject, const std::string& message) override;

 private:
  struct Request {
    std::string subject;
    Sender<ActionResult> done;
  };

  bool Close(const std::string& subject);
  void ReadConsole();
  void Answer(const std::string& text);

  ros::Publisher question_;
  ros::Subscriber answer_;
  std::mutex mutex_;
  std::vector<Request> open_;  // the newest is the last
  std::atomic<bool> stop_{false};
  std::thread reader_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_ROS_CONSOLE_SUPERVISOR_H_
