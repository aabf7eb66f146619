// ProcessManager on the services of the process supervisor. A service call blocks, so calls are
// made one after the other on a thread of their own.
#ifndef COPPICE_ROBOT_APP_ROS_ROS_PROCESS_MANAGER_H_
#define COPPICE_ROBOT_APP_ROS_ROS_PROCESS_MANAGER_H_

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "bt_nodes/processes/process_manager.h"

namespace coppice::robot::adapters {

class RosProcessManager : public leaves::ProcessManager {
 public:
  RosProcessManager();
  ~RosProcessManager() override;  // drops what was not begun, waits for the call in progress

  void RestartNode(const std::string& node, bool cleared,
                   Sender<leaves::ActionResult> done) override;
  void SetConfiguration(const std::string& configuration) override;
  void SetSite(const std::string& site, Sender<leaves::ActionResult> done) override;
  /// With COPPICE_SWITCH_OFF_TOKEN of the environment.
  void SwitchOff(const std::string& reason, Sender<leaves::ActionResult> done) override;

 private:
  void Enqueue(std::function<void()> call);
  void Work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> calls_;
  bool stop_ = false;
  std::thread worker_;
};

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_ROS_PROCESS_MANAGER_H_
