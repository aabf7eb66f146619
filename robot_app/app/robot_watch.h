// Looks at a running robot from outside, by its topics: what the demonstration and the system test
// wait for.
#ifndef COPPICE_ROBOT_APP_APP_ROBOT_WATCH_H_
#define COPPICE_ROBOT_APP_APP_ROBOT_WATCH_H_

#include <ros/node_handle.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "robot_app/app/crowd_figures.h"

namespace coppice::robot {

/// What is known of the robot at one moment.
struct RobotView {
  std::string
      application;  ///< status of the application tree: RUNNING, SUCCESS, FAILURE; empty: unknown
  std::string configuration;          ///< in force
  std::map<std::string, int> pids;    ///< of the running processes by name
  std::map<std::string, bool> ready;  ///< of all processes by name
  std::vector<std::string> given_up;  ///< processes that were restarted too often
  std::vector<std::string>
      errors;           ///< "monitor subject: message" of every entry that is an error or stale
  double x = 0, y = 0;  ///< true position in the map frame [m]
  double distance = 0;  ///< driven so far [m], from odometry
  double goal_x = 0;    ///< of the navigation's newest goal [m]
  bool has_goal = false;
  double time = 0;            ///< ROS time [s]
  int answers = 0;            ///< that were given to visitors so far
  std::string heard, answer;  ///< the newest: what was understood, what was said to it
  std::string led_to;         ///< the place to which its visitor wants to be led; or empty
  std::string outcome;        ///< of the newest wish to be led: arrived, lost ...; or empty
  CrowdFigures crowd;         ///< of all that was told of people so far
};

class RobotWatch {
 public:
  /// Subscribes; needs a running spinner.
  explicit RobotWatch(ros::NodeHandle& node);

  RobotView view() const;

  /// Waits until the predicate holds, at most that long in real time. `while_waiting` is called now
  /// and then while waiting. True if it came to hold.
  bool WaitFor(const std::function<bool(const RobotView&)>& predicate, double seconds,
               const std::function<void(const RobotView&)>& while_waiting = {});

 private:
  template <class Message>
  void Watch(ros::NodeHandle& node, const std::string& topic,
             std::function<void(const Message&, RobotView&)> update);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  RobotView view_;
  double last_x_ = 0, last_y_ = 0;
  bool has_odometry_ = false;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_APP_ROBOT_WATCH_H_
