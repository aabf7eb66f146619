#include "robot_app/app/robot_watch.h"

#include <coppice_msgs/Answer.h>
#include <coppice_msgs/Health.h>
#include <coppice_msgs/People.h>
#include <coppice_msgs/ProcessStates.h>
#include <geometry_msgs/PoseStamped.h>
#include <move_base_msgs/MoveBaseActionGoal.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <std_msgs/String.h>

#include <chrono>
#include <cmath>

namespace coppice::robot {
namespace {

void UpdateProcesses(const coppice_msgs::ProcessStates& message, RobotView& view) {
  view.configuration = message.configuration;
  view.pids.clear();
  view.ready.clear();
  view.given_up.clear();
  for (const coppice_msgs::ProcessState& process : message.processes) {
    if (process.pid > 0) view.pids[process.name] = process.pid;
    if (process.state == coppice_msgs::ProcessState::GIVEN_UP) {
      view.given_up.push_back(process.name);
    }
    view.ready[process.name] = process.state == coppice_msgs::ProcessState::READY;
  }
}

void UpdateHealth(const coppice_msgs::Health& message, RobotView& view) {
  view.errors.clear();
  for (const coppice_msgs::HealthEntry& entry : message.entries) {
    if (entry.level < coppice_msgs::HealthEntry::ERROR) continue;
    view.errors.push_back(entry.monitor + " " + entry.subject + ": " + entry.message);
  }
}

void UpdateAnswer(const coppice_msgs::Answer& message, RobotView& view) {
  ++view.answers;
  view.heard = message.heard.text;
  view.answer = message.text;
  view.led_to = message.guides ? message.place : "";
  view.outcome.clear();
}

}  // namespace

RobotWatch::RobotWatch(ros::NodeHandle& node) {
  Watch<std_msgs::String>(node, "/coppice/application", [](const auto& message, RobotView& view) {
    view.application = message.data;
  });
  Watch<coppice_msgs::ProcessStates>(node, "/processes", UpdateProcesses);
  Watch<coppice_msgs::People>(
      node, "/people", [](const auto& message, RobotView& view) { view.crowd.Add(message); });
  Watch<coppice_msgs::Answer>(node, "/speech/answer", UpdateAnswer);
  Watch<std_msgs::String>(node, "/visitors/outcome", [](const auto& message, RobotView& view) {
    view.outcome = message.data;
  });
  Watch<coppice_msgs::Health>(node, "/monitoring", UpdateHealth);
  Watch<geometry_msgs::PoseStamped>(node, "/simulation/truth",
                                    [](const auto& message, RobotView& view) {
                                      view.x = message.pose.position.x;
                                      view.y = message.pose.position.y;
                                    });
  Watch<move_base_msgs::MoveBaseActionGoal>(
      node, "/move_base/goal", [](const auto& message, RobotView& view) {
        view.goal_x = message.goal.target_pose.pose.position.x;
        view.has_goal = true;
      });
  Watch<nav_msgs::Odometry>(node, "/odom", [this](const auto& message, RobotView& view) {
    const double x = message.pose.pose.position.x;
    const double y = message.pose.pose.position.y;
    if (has_odometry_) view.distance += std::hypot(x - last_x_, y - last_y_);
    has_odometry_ = true;
    last_x_ = x;
    last_y_ = y;
    view.time = message.header.stamp.toSec();
  });
}

template <class Message>
void RobotWatch::Watch(ros::NodeHandle& node, const std::string& topic,
                       std::function<void(const Message&, RobotView&)> update) {
  const boost::function<void(const boost::shared_ptr<Message const>&)> callback =
      [this, update](const boost::shared_ptr<Message const>& message) {
        {
          const std::lock_guard<std::mutex> lock(mutex_);
          update(*message, view_);
        }
        changed_.notify_all();
      };
  subscribers_.push_back(node.subscribe<Message>(topic, 50, callback));
}

RobotView RobotWatch::view() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return view_;
}

bool RobotWatch::WaitFor(const std::function<bool(const RobotView&)>& predicate, double seconds,
                         const std::function<void(const RobotView&)>& while_waiting) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  std::unique_lock<std::mutex> lock(mutex_);
  while (!predicate(view_)) {
    if (std::chrono::steady_clock::now() >= deadline || !ros::ok()) return false;
    changed_.wait_for(lock, std::chrono::milliseconds(200));
    if (!while_waiting) continue;
    const RobotView now = view_;
    lock.unlock();
    while_waiting(now);
    lock.lock();
  }
  return true;
}

}  // namespace coppice::robot
