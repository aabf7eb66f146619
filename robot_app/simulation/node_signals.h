// Finds the process of a ROS node and sends it a signal, as a fault would.
//
// Speaks XML-RPC to the master (lookupNode, getSystemState) and to the node (getPid), each with a
// deadline, because the node may be hung (ROS Master and Slave API,
// wiki.ros.org/ROS/Master_Slave_APIs).
#ifndef COPPICE_ROBOT_APP_SIMULATION_NODE_SIGNALS_H_
#define COPPICE_ROBOT_APP_SIMULATION_NODE_SIGNALS_H_

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

#include "robot_app/simulation/world.h"

namespace coppice::robot::simulation {

class NodeSignals {
 public:
  /// `master_uri` is of the form http://host:port. `own_name` is the node that must never hit
  /// itself. `own_host` is the host name or address that this machine's nodes announce.
  NodeSignals(std::string master_uri, std::string own_name, std::string own_host);

  /// Sends `signal` to the process of `node`. A stopped process cannot tell its number, so the one
  /// that SIGSTOP went to is kept for SIGCONT. Refuses unknown nodes, nodes of another machine,
  /// this process and its ancestors. Takes at most about a second.
  Change Send(const std::string& node, int signal);

 private:
  Expected<pid_t> FindPid(const std::string& node) const;
  Problem UnknownNode(const std::string& node) const;
  std::vector<std::string> AllNodes() const;
  bool IsLocal(const std::string& host) const;

  std::string master_uri_;
  std::string own_name_;
  std::string own_host_;
  std::map<std::string, pid_t> stopped_;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_NODE_SIGNALS_H_
