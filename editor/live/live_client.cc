#include "editor/live/live_client.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <zmq.hpp>

namespace coppice::editor {
namespace {

std::string Join(const std::vector<std::string>& names) {
  std::string joined;
  for (const std::string& name : names) joined += (joined.empty() ? "" : ";") + name;
  return joined;
}

std::chrono::milliseconds Milliseconds(Duration duration) {
  return std::max(std::chrono::milliseconds(0),
                  std::chrono::ceil<std::chrono::milliseconds>(duration));
}

}  // namespace

const char* ToString(Connection connection) {
  switch (connection) {
    case Connection::kConnecting:
      return "connecting";
    case Connection::kLive:
      return "live";
    case Connection::kReconnecting:
      return "reconnecting";
  }
  return "?";
}

// The part that lives in the thread. Stop() alone is called from outside.
class LiveClient::Follower {
 public:
  explicit Follower(LiveClient& client)
      : client_(client), stop_in_(context_, ZMQ_PAIR), stop_out_(context_, ZMQ_PAIR) {
    stop_in_.bind("inproc://stop");
    stop_out_.connect("inproc://stop");
  }

  void Stop() { stop_out_.send(zmq::str_buffer("stop"), zmq::send_flags::none); }

  void Run() {
    Duration pause = client_.options_.first_pause;
    while (!stopped_) {
      if (Session()) pause = client_.options_.first_pause;
      if (stopped_) return;
      state_.connection = Connection::kReconnecting;
      state_.rate = 0;
      state_.next_try = client_.clock_.Now() + pause;
      client_.Publish(state_);
      Sleep(pause);
      pause = std::min(pause * 2, client_.options_.longest_pause);
    }
  }

 private:
  // One socket's life: until an answer is missing or wrong. True if there was a good one.
  bool Session() {
    zmq::socket_t socket(context_, ZMQ_REQ);
    socket.set(zmq::sockopt::linger, 0);
    try {
      socket.connect("tcp://" + client_.endpoint_);
    } catch (const zmq::error_t& error) {
      state_.error = std::string("cannot connect to ") + client_.endpoint_ + ": " + error.what();
      return false;
    }
    bool good = false;
    Time next_boards = client_.clock_.Now();
    while (!stopped_) {
      const Time start = client_.clock_.Now();
      if (!AskStatuses(socket)) return good;
      good = true;
      if (start >= next_boards) {
        if (!AskBoards(socket)) return good;
        next_boards = start + client_.options_.board_period;
      }
      client_.Publish(state_);
      Sleep(client_.options_.status_period - (client_.clock_.Now() - start));
      Measure(client_.clock_.Now() - start);
    }
    return good;
  }

  void Measure(Duration period) {
    const double rate = 1e9 / std::max<double>(static_cast<double>(period.count()), 1);
    state_.rate = state_.rate == 0 ? rate : 0.9 * state_.rate + 0.1 * rate;
  }

  bool AskStatuses(zmq::socket_t& socket) {
    const Time asked = client_.clock_.Now();
    const std::optional<Reply> reply = Ask(socket, RequestType::kStatus, {});
    if (!reply) return false;
    state_.round_trip = client_.clock_.Now() - asked;
    if (!state_.tree || state_.tree->id != reply->tree_id) return AskTree(socket);
    const auto statuses = DecodeStatuses(reply->payload);
    if (!statuses) return Fail("the robot sent statuses that cannot be read");
    Apply(*statuses);
    state_.connection = Connection::kLive;
    state_.error.clear();
    return true;
  }

  bool AskTree(zmq::socket_t& socket) {
    const std::optional<Reply> reply = Ask(socket, RequestType::kFullTree, {});
    if (!reply) return false;
    auto tree = std::make_shared<LiveTree>();
    tree->id = reply->tree_id;
    tree->forest = Forest::FromRobot(reply->payload, client_.endpoint_, tree->problems);
    if (tree->forest.trees().empty()) {
      return Fail("the robot sent a tree that cannot be read: " + tree->problems.ToString());
    }
    state_.tree = std::move(tree);
    state_.states.clear();
    state_.boards.clear();
    ++state_.sessions;
    return true;
  }

  bool AskBoards(zmq::socket_t& socket) {
    const std::vector<std::string> names = client_.watched();
    if (names.empty()) return true;
    const std::optional<Reply> reply = Ask(socket, RequestType::kBlackboard, Join(names));
    if (!reply) return false;
    auto boards = DecodeBoards(reply->payload);
    if (!boards) return Fail("the robot sent a blackboard that cannot be read");
    state_.boards = *std::move(boards);
    return true;
  }

  void Apply(const std::vector<NodeStatus>& statuses) {
    const Time now = client_.clock_.Now();
    for (const NodeStatus& node : statuses) {
      if (node.uid >= state_.states.size()) state_.states.resize(node.uid + 1U);
      NodeState& state = state_.states[node.uid];
      if (state.status != node.status || state.since == Time(0)) state.since = now;
      state.status = node.status;
      state.before = node.before;
    }
  }

  std::optional<Reply> Ask(zmq::socket_t& socket, RequestType type, const std::string& body) {
    ++number_;
    const std::string header = EncodeRequest(type, number_);
    try {
      socket.send(zmq::buffer(header),
                  body.empty() ? zmq::send_flags::none : zmq::send_flags::sndmore);
      if (!body.empty()) socket.send(zmq::buffer(body), zmq::send_flags::none);
      const std::vector<std::string> parts = Receive(socket);
      if (parts.empty()) return std::nullopt;
      std::string error;
      std::optional<Reply> reply = DecodeReply(parts, type, number_, error);
      if (!reply) Fail(error);
      return reply;
    } catch (const zmq::error_t& error) {
      Fail(error.what());
      return std::nullopt;
    }
  }

  // Empty if stopped or too late.
  std::vector<std::string> Receive(zmq::socket_t& socket) {
    zmq::pollitem_t items[] = {{socket.handle(), 0, ZMQ_POLLIN, 0},
                               {stop_in_.handle(), 0, ZMQ_POLLIN, 0}};
    zmq::poll(items, 2, Milliseconds(client_.options_.reply_timeout));
    stopped_ = stopped_ || (items[1].revents & ZMQ_POLLIN);
    if (stopped_) return {};
    if (!(items[0].revents & ZMQ_POLLIN)) {
      Fail("no answer from " + client_.endpoint_);
      return {};
    }
    std::vector<std::string> parts;
    zmq::message_t part;
    do {
      static_cast<void>(socket.recv(part, zmq::recv_flags::none));
      parts.push_back(part.to_string());
    } while (part.more());
    return parts;
  }

  bool Fail(std::string why) {
    state_.error = std::move(why);
    return false;
  }

  void Sleep(Duration duration) {
    zmq::pollitem_t item = {stop_in_.handle(), 0, ZMQ_POLLIN, 0};
    zmq::poll(&item, 1, Milliseconds(duration));
    stopped_ = stopped_ || (item.revents & ZMQ_POLLIN);
  }

  LiveClient& client_;
  zmq::context_t context_;
  zmq::socket_t stop_in_;
  zmq::socket_t stop_out_;
  LiveSnapshot state_;
  std::uint32_t number_ = 0;
  bool stopped_ = false;
};

LiveClient::LiveClient(std::string endpoint, const Clock& clock, std::function<void()> on_change,
                       LiveClientOptions options)
    : endpoint_(std::move(endpoint)),
      clock_(clock),
      on_change_(std::move(on_change)),
      options_(options),
      snapshot_(std::make_shared<LiveSnapshot>()),
      follower_(std::make_unique<Follower>(*this)),
      thread_([this] { follower_->Run(); }) {}

LiveClient::~LiveClient() {
  follower_->Stop();
  thread_.join();
}

std::shared_ptr<const LiveSnapshot> LiveClient::snapshot() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return snapshot_;
}

void LiveClient::Watch(std::vector<std::string> boards) {
  const std::lock_guard<std::mutex> lock(mutex_);
  watched_ = std::move(boards);
}

std::vector<std::string> LiveClient::watched() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return watched_;
}

void LiveClient::Publish(LiveSnapshot snapshot) {
  auto published = std::make_shared<const LiveSnapshot>(std::move(snapshot));
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    snapshot_.swap(published);
  }
  if (on_change_) on_change_();
}

}  // namespace coppice::editor
