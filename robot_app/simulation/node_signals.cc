#include "robot_app/simulation/node_signals.h"

#include <signal.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpc.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>
#include <set>

namespace coppice::robot::simulation {
namespace {

constexpr std::chrono::milliseconds kDeadline{500};

struct Address {
  std::string host;
  int port = 0;
};

// Of "http://host:port/".
std::optional<Address> ParseUri(const std::string& uri) {
  const std::string scheme = "http://";
  if (uri.compare(0, scheme.size(), scheme) != 0) return std::nullopt;
  const std::string rest = uri.substr(scheme.size(), uri.find('/', scheme.size()) - scheme.size());
  const std::size_t colon = rest.rfind(':');
  if (colon == std::string::npos) return std::nullopt;
  const int port = std::atoi(rest.c_str() + colon + 1);
  if (port <= 0 || port > 65535) return std::nullopt;
  return Address{rest.substr(0, colon), port};
}

// One call of the ROS API: the third member of the answer [code, text, value], if the code is 1.
std::optional<XmlRpc::XmlRpcValue> Call(const std::string& uri, const char* method,
                                        const std::vector<std::string>& arguments) {
  const auto address = ParseUri(uri);
  if (!address) return std::nullopt;
  XmlRpc::XmlRpcValue params;
  for (std::size_t i = 0; i < arguments.size(); ++i) params[static_cast<int>(i)] = arguments[i];
  XmlRpc::XmlRpcClient client(address->host.c_str(), address->port, "/");
  XmlRpc::XmlRpcDispatch dispatch;
  if (!client.executeNonBlock(method, params)) return std::nullopt;
  dispatch.addSource(&client,
                     XmlRpc::XmlRpcDispatch::WritableEvent | XmlRpc::XmlRpcDispatch::Exception);
  XmlRpc::XmlRpcValue answer;
  const auto deadline = std::chrono::steady_clock::now() + kDeadline;
  bool done = false;
  while (!(done = client.executeCheckDone(answer))) {
    if (std::chrono::steady_clock::now() > deadline) break;
    dispatch.work(0.02);
  }
  dispatch.removeSource(&client);
  client.close();
  if (!done || client.isFault()) return std::nullopt;
  if (answer.getType() != XmlRpc::XmlRpcValue::TypeArray || answer.size() != 3) return std::nullopt;
  if (answer[0].getType() != XmlRpc::XmlRpcValue::TypeInt || static_cast<int>(answer[0]) != 1) {
    return std::nullopt;
  }
  return answer[2];
}

// The parent of a process, by the fourth field of /proc/PID/stat; 0 if unknown.
pid_t ParentOf(pid_t pid) {
  std::string path = "/proc/" + std::to_string(pid) + "/stat";
  FILE* file = std::fopen(path.c_str(), "r");
  if (file == nullptr) return 0;
  int parent = 0;
  const int found = std::fscanf(file, "%*d (%*[^)]) %*c %d", &parent);
  std::fclose(file);
  return found == 1 ? parent : 0;
}

bool IsSelfOrAncestor(pid_t pid) {
  for (pid_t p = getpid(); p > 1; p = ParentOf(p)) {
    if (p == pid) return true;
  }
  return false;
}

const char* Deed(int signal) {
  if (signal == SIGKILL) return "killed";
  if (signal == SIGSTOP) return "stopped";
  return signal == SIGCONT ? "resumed" : "signalled";
}

}  // namespace

NodeSignals::NodeSignals(std::string master_uri, std::string own_name, std::string own_host)
    : master_uri_(std::move(master_uri)),
      own_name_(std::move(own_name)),
      own_host_(std::move(own_host)) {}

bool NodeSignals::IsLocal(const std::string& host) const {
  return host == own_host_ || host == "localhost" || host == "127.0.0.1";
}

std::vector<std::string> NodeSignals::AllNodes() const {
  std::set<std::string> names;
  auto state = Call(master_uri_, "getSystemState", {own_name_});
  // Three lists (publishers, subscribers, services) of [name, [node, ...]].
  for (int list = 0; state && list < state->size(); ++list) {
    XmlRpc::XmlRpcValue& entries = (*state)[list];
    for (int i = 0; i < entries.size(); ++i) {
      for (int k = 0; k < entries[i][1].size(); ++k) names.insert(entries[i][1][k]);
    }
  }
  return {names.begin(), names.end()};
}

Problem NodeSignals::UnknownNode(const std::string& node) const {
  const std::vector<std::string> nodes = AllNodes();
  const std::string hint = DidYouMean(node, nodes);
  std::string list;
  for (const std::string& name : nodes) list += (list.empty() ? "" : ", ") + name;
  return Problem{"the master knows no node \"" + node + "\"" +
                 (hint.empty() ? "; known: " + list : " (" + hint + ")")};
}

Expected<pid_t> NodeSignals::FindPid(const std::string& node) const {
  auto uri = Call(master_uri_, "lookupNode", {own_name_, node});
  if (!uri) return UnknownNode(node);
  const std::string node_uri = *uri;
  const auto address = ParseUri(node_uri);
  if (!address || !IsLocal(address->host)) {
    return Problem{node + " runs on another machine (" + node_uri + ")"};
  }
  auto number = Call(node_uri, "getPid", {own_name_});
  if (!number || number->getType() != XmlRpc::XmlRpcValue::TypeInt) {
    return Problem{node + " does not answer at " + node_uri};
  }
  return static_cast<int>(*number);
}

Change NodeSignals::Send(const std::string& name, int signal) {
  const std::string node = !name.empty() && name[0] == '/' ? name : "/" + name;
  pid_t pid = 0;
  const auto stopped = stopped_.find(node);
  if (stopped != stopped_.end() && signal != SIGSTOP) {
    pid = stopped->second;
    stopped_.erase(stopped);
  } else {
    const Expected<pid_t> found = FindPid(node);
    if (!found) return Problem{found.problem()};
    pid = *found;
  }
  if (node == own_name_ || pid <= 1 || IsSelfOrAncestor(pid)) {
    return Problem{"the simulator does not signal itself or what started it (" + node + ")"};
  }
  const std::string who = node + " (process " + std::to_string(pid) + ")";
  if (kill(pid, signal) == 0) {
    if (signal == SIGSTOP) stopped_[node] = pid;
    return who + " is " + Deed(signal);
  }
  if (errno == ESRCH) return who + " had already ended";
  return Problem{"cannot signal " + who + ": " + std::strerror(errno)};
}

}  // namespace coppice::robot::simulation
