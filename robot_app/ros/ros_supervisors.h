// SupervisorChannel on the node /assistance. Its services are called on a thread of their own, so
// no tree ever waits for them; while the node is down, what is to be said is kept and tried again
// every second, and a request that a restarted node does not know any more is asked anew.
#ifndef COPPICE_ROBOT_APP_ROS_ROS_SUPERVISORS_H_
#define COPPICE_ROBOT_APP_ROS_ROS_SUPERVISORS_H_

#include <coppice_msgs/HelpRequests.h>
#include <ros/node_handle.h>

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "bt_nodes/operators/supervisor_channel.h"

namespace coppice::robot::adapters {

class RosSupervisors : public leaves::SupervisorChannel {
 public:
  static constexpr std::size_t kMostWaiting = 100;  ///< messages; then the oldest is dropped

  explicit RosSupervisors(ros::NodeHandle& node);
  ~RosSupervisors() override;  // drops what was not begun, waits for the call in progress

  void Ask(const std::string& subject, const std::string& question,
           Sender<leaves::ActionResult> done) override;
  void Withdraw(const std::string& subject) override;
  void Tell(const std::string& subject, const std::string& message) override;

 private:
  struct Open {
    std::string question;
    Sender<leaves::ActionResult> done;
    std::uint32_t id = 0;  // 0: the node has not been asked yet
    std::uint64_t edition = 0;
  };
  using Call = std::function<bool()>;  // false: the node does not answer

  void Work();
  bool Do(std::unique_lock<std::mutex>& lock);
  Call NextQuestion();
  Call MakeAsk(const std::string& subject, const Open& open);
  void OnAsked(const std::string& subject, std::uint64_t edition, std::uint32_t id);
  void Look();
  void Enqueue(Call call);

  std::mutex mutex_;  // for all but the last two
  std::condition_variable changed_;
  std::map<std::string, Open> open_;
  std::deque<Call> calls_;
  coppice_msgs::HelpRequests::ConstPtr list_;
  std::uint64_t editions_ = 0;
  bool stop_ = false;
  ros::Subscriber subscriber_;
  std::thread worker_;
};

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_ROS_SUPERVISORS_H_
