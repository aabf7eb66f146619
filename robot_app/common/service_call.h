// Calls of ROS services that end at a deadline. ros::service::call waits for ever when the program
// that serves hangs: its kernel still takes connections.
#ifndef COPPICE_ROBOT_APP_COMMON_SERVICE_CALL_H_
#define COPPICE_ROBOT_APP_COMMON_SERVICE_CALL_H_

#include <ros/service.h>

#include <chrono>
#include <future>
#include <string>

#include "bt_core/base/clock.h"

namespace coppice::robot {

/// True when the answer lies in `service`; false if nobody offers the service, or no answer has
/// come within `deadline` of wall time. Blocks; any thread.
template <class Service>
bool CallService(const std::string& name, Service& service,
                 Duration deadline = std::chrono::seconds(5)) {
  // Persistent, because only the connection of such a client can be cut from another thread.
  ros::ServiceClient client = ros::service::createClient<Service>(name, true);
  if (!client.isValid()) return false;
  auto answer = std::async(std::launch::async, [&] { return client.call(service); });
  if (answer.wait_for(deadline) == std::future_status::timeout) client.shutdown();
  return answer.get();
}

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_SERVICE_CALL_H_
