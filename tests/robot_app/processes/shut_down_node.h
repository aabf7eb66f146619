// What anybody in a ROS graph may do to any node: tell it by XML-RPC that it has to shut down
// (http://wiki.ros.org/ROS/Slave_API). The program behind it need not have heard of that.
#ifndef COPPICE_TESTS_ROBOT_APP_PROCESSES_SHUT_DOWN_NODE_H_
#define COPPICE_TESTS_ROBOT_APP_PROCESSES_SHUT_DOWN_NODE_H_

#include <xmlrpcpp/XmlRpc.h>

#include <string>

#include "robot_app/common/node_probe.h"

namespace coppice::robot::processes {

/// False if the master does not know the node, or the node does not answer.
inline bool ShutDownNode(const NodeAddress& master, const std::string& node) {
  XmlRpc::XmlRpcValue request, answer;
  request[0] = "/stranger";
  request[1] = node;
  XmlRpc::XmlRpcClient ask(master.host.c_str(), master.port);
  if (!ask.execute("lookupNode", request, answer) || static_cast<int>(answer[0]) != 1) return false;
  const auto address = ParseUri(static_cast<std::string>(answer[2]));
  if (!address) return false;
  request[1] = "a stranger says so";
  XmlRpc::XmlRpcClient tell(address->host.c_str(), address->port);
  return tell.execute("shutdown", request, answer);
}

}  // namespace coppice::robot::processes

#endif  // COPPICE_TESTS_ROBOT_APP_PROCESSES_SHUT_DOWN_NODE_H_
