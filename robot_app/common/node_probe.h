// Asking ROS nodes whether they are alive: really, over the network, and all at the same time.
//
// A probe asks the master where the node is (lookupNode) and then the node itself for its pid
// (getPid of the slave API, http://wiki.ros.org/ROS/Slave_API), so a node that hangs does not pass.
// The connection to a node that has answered is kept: the master is asked again only now and then,
// and when the node does not answer there any more.
// Plain XML-RPC: needs no ros::init and never blocks longer than it is told.
#ifndef COPPICE_ROBOT_APP_COMMON_NODE_PROBE_H_
#define COPPICE_ROBOT_APP_COMMON_NODE_PROBE_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"

namespace XmlRpc {
class XmlRpcValue;
}

namespace coppice::robot {

struct NodeAddress {
  std::string host;
  int port = 0;
};

/// "http://host:port/", as in ROS_MASTER_URI.
std::optional<NodeAddress> ParseUri(const std::string& uri);

struct ProbeRequest {
  std::string node;          ///< with slash
  std::string topic;         ///< if not empty: the node must also say that it publishes this
  std::string service = {};  ///< if not empty: this service must accept connections
};

struct ProbeResult {
  bool answered = false;
  int pid = 0;                    ///< as the node says
  Duration delay{0};              ///< until the answer
  std::string reason;             ///< why not answered, for people
  std::string host = {};          ///< where the node is, as it is registered; empty: not known
  bool is_master_silent = false;  ///< the master was asked, and said nothing until the deadline
};

/// One sweep over several nodes at a time. For one thread.
class NodeProbe {
 public:
  /// With a kept connection, so many sweeps go by until the master is asked again.
  static constexpr unsigned kSweepsPerLookup = 20;

  /// `caller`: our own ROS name, for the logs of those that are asked.
  NodeProbe(NodeAddress master, std::string caller);
  ~NodeProbe();
  NodeProbe(const NodeProbe&) = delete;
  NodeProbe& operator=(const NodeProbe&) = delete;

  /// Starts a sweep; one that is under way is dropped. A node that has not answered after
  /// `deadline` counts as silent.
  void Begin(std::vector<ProbeRequest> requests, Duration deadline);

  /// Goes on with the sweep for at most this long. True when it is complete (or none was begun).
  bool Work(Duration at_most);

  bool busy() const;
  /// Of the complete sweep, in the order of the requests.
  const std::vector<ProbeRequest>& requests() const { return requests_; }
  const std::vector<ProbeResult>& results() const { return results_; }

  /// Keeps the XML-RPC library from printing every refused connection; the results tell it. Once
  /// per program.
  static void SilenceLibrary();

 private:
  struct Call;
  struct Connections;
  struct Sweep;

  NodeAddress master_;
  std::string caller_;
  std::vector<ProbeRequest> requests_;
  std::vector<ProbeResult> results_;
  std::unique_ptr<Connections> connections_;
  std::unique_ptr<Sweep> sweep_;
  unsigned sweeps_ = 0;
};

/// True if a ROS master answers there. Blocks until the answer or the deadline; so does the next.
bool MasterAnswers(const NodeAddress& master, Duration deadline);

/// A call of the master's or the parameter server's API. True if it was granted in time.
bool CallMaster(const NodeAddress& master, const char* method, const XmlRpc::XmlRpcValue& arguments,
                Duration deadline);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_NODE_PROBE_H_
