#include "robot_app/ros/ros_process_manager.h"

#include <coppice_msgs/RestartProcess.h>
#include <coppice_msgs/SetConfiguration.h>
#include <coppice_msgs/SetSite.h>
#include <coppice_msgs/SwitchOff.h>
#include <ros/console.h>

#include <cstdlib>
#include <utility>

#include "robot_app/common/service_call.h"

namespace coppice::robot::adapters {
namespace {

using leaves::ActionResult;

// A service that is not there, or hangs, is an answer, not an exception.
template <class Service>
ActionResult Call(const std::string& name, Service& service) {
  if (!CallService(name, service)) return {false, "service " + name + " does not answer"};
  return {static_cast<bool>(service.response.ok), service.response.message};
}

}  // namespace

RosProcessManager::RosProcessManager() : worker_([this] { Work(); }) {}

RosProcessManager::~RosProcessManager() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
    calls_.clear();
  }
  changed_.notify_one();
  worker_.join();
}

void RosProcessManager::RestartNode(const std::string& node, bool cleared,
                                    Sender<ActionResult> done) {
  Enqueue([node, cleared, done] {
    coppice_msgs::RestartProcess service;
    service.request.name = node;
    service.request.cleared = cleared;
    done.Send(Call("/supervisor/restart", service));
  });
}

void RosProcessManager::SetConfiguration(const std::string& configuration) {
  Enqueue([configuration] {
    coppice_msgs::SetConfiguration service;
    service.request.configuration = configuration;
    const ActionResult result = Call("/supervisor/set_configuration", service);
    if (!result.ok) {
      ROS_WARN_STREAM("configuration " << configuration << ": " << result.message);
    }
  });
}

void RosProcessManager::SetSite(const std::string& site, Sender<ActionResult> done) {
  Enqueue([site, done] {
    coppice_msgs::SetSite service;
    service.request.site = site;
    done.Send(Call("/supervisor/set_site", service));
  });
}

void RosProcessManager::SwitchOff(const std::string& reason, Sender<ActionResult> done) {
  Enqueue([reason, done] {
    coppice_msgs::SwitchOff service;
    service.request.reason = reason;
    if (const char* token = std::getenv("COPPICE_SWITCH_OFF_TOKEN")) service.request.token = token;
    done.Send(Call("/supervisor/switch_off", service));
  });
}

void RosProcessManager::Enqueue(std::function<void()> call) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    calls_.push_back(std::move(call));
  }
  changed_.notify_one();
}

void RosProcessManager::Work() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stop_ || !calls_.empty(); });
    if (stop_) return;
    const std::function<void()> call = std::move(calls_.front());
    calls_.pop_front();
    lock.unlock();
    call();
    lock.lock();
  }
}

}  // namespace coppice::robot::adapters
