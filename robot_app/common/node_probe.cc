#include "robot_app/common/node_probe.h"

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpc.h>
#include <xmlrpcpp/XmlRpcDispatch.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <algorithm>
#include <map>
#include <new>
#include <thread>
#include <utility>

namespace coppice::robot {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr Duration kConnectTime = std::chrono::milliseconds(100);

constexpr int kMostAnswer = 16 << 20;     // bytes
constexpr std::size_t kDeepestValue = 8;  // the ROS APIs have arrays in arrays of an array

// The library takes an array apart by recursion, which a deep one ends with the program.
bool IsDeep(const std::string& answer) {
  std::size_t depth = 0;
  for (std::size_t at = 0; (at = answer.find('<', at)) != std::string::npos; ++at) {
    if (answer.compare(at, 6, "<value") == 0 && ++depth > kDeepestValue) return true;
    if (answer.compare(at, 7, "</value") == 0 && depth > 0) --depth;
  }
  return false;
}

// Makes the connection's state visible: the library reports a refused connection nowhere else. And
// believes nobody: who answers without end, or with what the library chokes on, does not answer.
class Client : public XmlRpc::XmlRpcClient {
 public:
  explicit Client(const NodeAddress& to) : XmlRpcClient(to.host.c_str(), to.port, "/") {}
  bool failed() const { return _connectionState == NO_CONNECTION; }

  unsigned handleEvent(unsigned event) override {
    try {
      return XmlRpcClient::handleEvent(event);
    } catch (const std::bad_alloc&) {
      close();
      return 0;
    }
  }

 private:
  bool readHeader() override {
    if (!XmlRpcClient::readHeader()) return false;
    if (_contentLength <= kMostAnswer) return true;
    close();
    return false;
  }

  bool parseResponse(XmlRpc::XmlRpcValue& result) override {
    try {
      if (!IsDeep(_response)) return XmlRpcClient::parseResponse(result);
    } catch (const XmlRpc::XmlRpcException&) {
    }
    result.clear();
    return false;
  }
};

class QuietHandler : public XmlRpc::XmlRpcErrorHandler {
 public:
  void error(const char*) override {}
};

// A refused connection ends as an answer without content.
bool IsEmpty(const XmlRpc::XmlRpcValue& answer) {
  return answer.getType() == XmlRpc::XmlRpcValue::TypeInvalid;
}

// The value of an answer [1, message, value] of the ROS APIs.
std::optional<XmlRpc::XmlRpcValue> Unwrap(XmlRpc::XmlRpcValue& answer) {
  using Value = XmlRpc::XmlRpcValue;
  if (answer.getType() != Value::TypeArray || answer.size() != 3) return std::nullopt;
  if (answer[0].getType() != Value::TypeInt || static_cast<int>(answer[0]) != 1) {
    return std::nullopt;
  }
  return answer[2];
}

bool Connects(const addrinfo& address, Duration deadline) {
  const int connection = socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (connection < 0) return false;
  connect(connection, address.ai_addr, address.ai_addrlen);
  pollfd ready{connection, POLLOUT, 0};
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(deadline).count();
  int error = -1;
  socklen_t size = sizeof(error);
  const bool connected = poll(&ready, 1, static_cast<int>(ms)) == 1 &&
                         getsockopt(connection, SOL_SOCKET, SO_ERROR, &error, &size) == 0 &&
                         error == 0;
  close(connection);
  return connected;
}

bool AcceptsConnections(const NodeAddress& to, Duration deadline) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* addresses = nullptr;
  if (getaddrinfo(to.host.c_str(), std::to_string(to.port).c_str(), &hints, &addresses) != 0) {
    return false;
  }
  const bool connected = Connects(*addresses, deadline);
  freeaddrinfo(addresses);
  return connected;
}

bool Publishes(XmlRpc::XmlRpcValue& topics, const std::string& wanted) {
  if (topics.getType() != XmlRpc::XmlRpcValue::TypeArray) return false;
  for (int i = 0; i < topics.size(); ++i) {
    if (topics[i].getType() != XmlRpc::XmlRpcValue::TypeArray || topics[i].size() < 1) continue;
    if (topics[i][0].getType() != XmlRpc::XmlRpcValue::TypeString) continue;
    if (static_cast<std::string>(topics[i][0]) == wanted) return true;
  }
  return false;
}

// Of "scheme://host:port/".
std::optional<NodeAddress> ParseAddress(const std::string& uri, const std::string& scheme) {
  if (uri.rfind(scheme, 0) != 0) return std::nullopt;
  const std::string rest = uri.substr(scheme.size());
  const std::size_t colon = rest.find(':');
  if (colon == 0 || colon == std::string::npos) return std::nullopt;
  int port = 0;
  for (std::size_t i = colon + 1; i < rest.size() && rest[i] != '/'; ++i) {
    if (rest[i] < '0' || rest[i] > '9') return std::nullopt;
    port = 10 * port + (rest[i] - '0');
    if (port > 65535) return std::nullopt;
  }
  if (port == 0) return std::nullopt;
  return NodeAddress{rest.substr(0, colon), port};
}

// The master remembers services of nodes that were killed, so the answer of lookupService alone
// means little.
bool IsOpen(XmlRpc::XmlRpcValue& service) {
  if (service.getType() != XmlRpc::XmlRpcValue::TypeString) return false;
  const auto address = ParseAddress(static_cast<std::string>(service), "rosrpc://");
  return address && AcceptsConnections(*address, kConnectTime);
}

}  // namespace

std::optional<NodeAddress> ParseUri(const std::string& uri) { return ParseAddress(uri, "http://"); }

// Open connections to nodes that have answered, by their names.
struct NodeProbe::Connections {
  std::map<std::string, std::unique_ptr<Client>> by_node;

  std::unique_ptr<Client> Take(const std::string& node) {
    const auto found = by_node.find(node);
    if (found == by_node.end()) return nullptr;
    std::unique_ptr<Client> client = std::move(found->second);
    by_node.erase(found);
    return client;
  }
};

// The probe of one node: up to four calls, one after the other.
struct NodeProbe::Call {
  enum class Step { kLookup, kPid, kPublications, kService, kDone };

  const ProbeRequest* request = nullptr;
  ProbeResult* result = nullptr;
  Step step = Step::kLookup;
  std::unique_ptr<Client> client;  // to whom the question is
  std::unique_ptr<Client> kept;    // to the node, while the master is asked
  bool trusts_kept = false;        // the master was not asked in this sweep

  void Ask(const char* method, const XmlRpc::XmlRpcValue& arguments,
           XmlRpc::XmlRpcDispatch& dispatch) {
    if (!client->executeNonBlock(method, arguments)) return;
    using Dispatch = XmlRpc::XmlRpcDispatch;
    dispatch.addSource(client.get(), Dispatch::WritableEvent | Dispatch::Exception);
  }

  // The connection to the node at this address: the kept one if it leads there.
  void ConnectTo(const NodeAddress& node) {
    const bool is_known = kept && kept->getHost() == node.host && kept->getPort() == node.port;
    client = is_known ? std::move(kept) : std::make_unique<Client>(node);
    kept.reset();
  }

  void End(bool answered, std::string reason) {
    step = Step::kDone;
    result->answered = answered;
    result->reason = std::move(reason);
    client.reset();
  }

  void EndInSilence() {
    result->is_master_silent = step == Step::kLookup || step == Step::kService;
    End(false, result->is_master_silent ? "the ROS master does not answer" : "does not answer");
  }
};

struct NodeProbe::Sweep {
  XmlRpc::XmlRpcDispatch dispatch;
  std::vector<Call> calls;
  SteadyClock::time_point begun;
  SteadyClock::time_point deadline;
  std::string caller;
  NodeAddress master;
  Connections* connections = nullptr;

  XmlRpc::XmlRpcValue Arguments() const {
    XmlRpc::XmlRpcValue arguments;
    arguments[0] = caller;
    return arguments;
  }

  void LookUp(Call& call) {
    call.step = Call::Step::kLookup;
    call.trusts_kept = false;
    call.client = std::make_unique<Client>(master);
    XmlRpc::XmlRpcValue arguments = Arguments();
    arguments[1] = call.request->node;
    call.Ask("lookupNode", arguments, dispatch);
  }

  void Begin(Call& call, bool ask_master) {
    call.kept = connections->Take(call.request->node);
    if (!call.kept || ask_master) return LookUp(call);
    call.client = std::move(call.kept);
    call.trusts_kept = true;
    call.step = Call::Step::kPid;
    call.Ask("getPid", Arguments(), dispatch);
  }

  void Succeed(Call& call) {
    auto& connection = call.kept ? call.kept : call.client;
    connections->by_node[call.request->node] = std::move(connection);
    call.End(true, "");
  }

  bool done() const {
    return std::all_of(calls.begin(), calls.end(),
                       [](const Call& call) { return call.step == Call::Step::kDone; });
  }

  void Advance(Call& call) {
    XmlRpc::XmlRpcValue answer;
    const bool done = call.client->executeCheckDone(answer);
    if (!done && !call.client->failed()) return;
    dispatch.removeSource(call.client.get());
    if (done && !IsEmpty(answer)) {
      Answered(call, Unwrap(answer));
    } else if (call.trusts_kept) {  // it may be somewhere else now
      LookUp(call);
    } else {
      const std::string where = call.step == Call::Step::kLookup ? "the ROS master " : "";
      call.End(false, where + "refuses connections");
    }
  }

  void AskForService(Call& call) {
    if (call.request->service.empty()) return Succeed(call);
    call.kept = std::move(call.client);
    call.client = std::make_unique<Client>(master);
    XmlRpc::XmlRpcValue arguments = Arguments();
    arguments[1] = call.request->service;
    call.step = Call::Step::kService;
    call.Ask("lookupService", arguments, dispatch);
  }

  void Answered(Call& call, std::optional<XmlRpc::XmlRpcValue> value) {
    switch (call.step) {
      case Call::Step::kLookup: {
        const auto address = value && value->getType() == XmlRpc::XmlRpcValue::TypeString
                                 ? ParseUri(static_cast<std::string>(*value))
                                 : std::nullopt;
        if (!address) return call.End(false, "unknown to the ROS master");
        call.ConnectTo(*address);
        call.step = Call::Step::kPid;
        return call.Ask("getPid", Arguments(), dispatch);
      }
      case Call::Step::kPid:
        if (!value || value->getType() != XmlRpc::XmlRpcValue::TypeInt) {
          return call.End(false, "answers nonsense");
        }
        call.result->pid = static_cast<int>(*value);
        call.result->host = call.client->getHost();
        call.result->delay = SteadyClock::now() - begun;
        call.trusts_kept = false;  // it is the node
        if (call.request->topic.empty()) return AskForService(call);
        call.step = Call::Step::kPublications;
        return call.Ask("getPublications", Arguments(), dispatch);
      case Call::Step::kPublications:
        if (value && Publishes(*value, call.request->topic)) return AskForService(call);
        return call.End(false, "does not publish " + call.request->topic);
      case Call::Step::kService:
        if (value && IsOpen(*value)) return Succeed(call);
        return call.End(false, "does not offer " + call.request->service);
      case Call::Step::kDone:
        return;
    }
  }

  void ExpireAll() {
    for (Call& call : calls) {
      if (call.step == Call::Step::kDone) continue;
      dispatch.removeSource(call.client.get());
      call.EndInSilence();
    }
  }
};

NodeProbe::NodeProbe(NodeAddress master, std::string caller)
    : master_(std::move(master)),
      caller_(std::move(caller)),
      connections_(std::make_unique<Connections>()) {}

NodeProbe::~NodeProbe() = default;

bool NodeProbe::busy() const { return sweep_ != nullptr; }

void NodeProbe::Begin(std::vector<ProbeRequest> requests, Duration deadline) {
  requests_ = std::move(requests);
  results_.assign(requests_.size(), {});
  sweep_ = std::make_unique<Sweep>();
  sweep_->begun = SteadyClock::now();
  sweep_->deadline = sweep_->begun + deadline;
  sweep_->caller = caller_;
  sweep_->master = master_;
  sweep_->connections = connections_.get();
  ++sweeps_;
  sweep_->calls.resize(requests_.size());
  for (std::size_t i = 0; i < requests_.size(); ++i) {
    Call& call = sweep_->calls[i];
    call.request = &requests_[i];
    call.result = &results_[i];
    sweep_->Begin(call, (sweeps_ + i) % kSweepsPerLookup == 0);
  }
}

bool NodeProbe::Work(Duration at_most) {
  if (!sweep_) return true;
  // To be woken by every answer costs more than to read it: they are left to gather.
  constexpr Duration kGather = std::chrono::milliseconds(3);
  const auto until = std::min(SteadyClock::now() + at_most, sweep_->deadline);
  while (true) {
    sweep_->dispatch.work(0);
    for (Call& call : sweep_->calls) {
      if (call.step != Call::Step::kDone) sweep_->Advance(call);
    }
    if (sweep_->done() || SteadyClock::now() >= until) break;
    std::this_thread::sleep_for(kGather);
  }
  if (!sweep_->done() && SteadyClock::now() >= sweep_->deadline) sweep_->ExpireAll();
  if (!sweep_->done()) return false;
  sweep_.reset();
  return true;
}

void NodeProbe::SilenceLibrary() {
  static QuietHandler handler;
  XmlRpc::XmlRpcErrorHandler::setErrorHandler(&handler);
}

bool MasterAnswers(const NodeAddress& master, Duration deadline) {
  XmlRpc::XmlRpcValue arguments;
  arguments[0] = "/coppice";
  return CallMaster(master, "getPid", arguments, deadline);
}

bool CallMaster(const NodeAddress& master, const char* method, const XmlRpc::XmlRpcValue& arguments,
                Duration deadline) {
  XmlRpc::XmlRpcValue answer;
  Client client(master);
  XmlRpc::XmlRpcDispatch dispatch;
  if (!client.executeNonBlock(method, arguments)) return false;
  using Dispatch = XmlRpc::XmlRpcDispatch;
  dispatch.addSource(&client, Dispatch::WritableEvent | Dispatch::Exception);
  const auto until = SteadyClock::now() + deadline;
  bool done = false;
  while (!done && !client.failed() && SteadyClock::now() < until) {
    dispatch.work(0.01);
    done = client.executeCheckDone(answer);
  }
  dispatch.removeSource(&client);
  client.close();
  return done && Unwrap(answer).has_value();
}

}  // namespace coppice::robot
