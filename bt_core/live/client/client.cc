#include "bt_core/live/client/client.h"

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "bt_core/live/client/client_extension.h"
#include "bt_core/live/client/client_socket.h"
#include "bt_core/live/groot2/client_groot2.h"

namespace coppice {
namespace {

constexpr Duration kRetryPause = std::chrono::milliseconds(100);
constexpr Duration kPatience = std::chrono::milliseconds(1000);  // then people are told
constexpr std::size_t kLongestProblem = 1000;                    // bytes, of what a robot says
constexpr int kMessagesPerRound = 64;                            // then commands have their turn

Duration Now() { return std::chrono::steady_clock::now().time_since_epoch(); }

}  // namespace

// The thread of a client: one connection after the other, each with a session of the protocol that
// the robot knows.
class LiveClient::Loop {
 public:
  Loop(const std::string& endpoint, LiveListener& listener, LiveClientOptions options)
      : endpoint_(endpoint),
        address_(AddressOf(endpoint)),
        options_(std::move(options)),
        listener_(listener),
        history_(listener),
        groot2_history_(listener, endpoint) {
    if (!options_.token.empty()) keys_ = KeysOfWatcher(options_.token);
    thread_ = std::thread([this] { Run(); });
  }

  ~Loop() {
    stop_ = true;
    bell_.Ring();
    thread_.join();
  }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  void Send(LiveCommand command, ReplyHandler on_reply) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      commands_.push_back({std::move(command), std::move(on_reply)});
    }
    bell_.Ring();
  }

 private:
  struct Asked {
    LiveCommand command;
    ReplyHandler on_reply;
  };

  void Run() {
    pthread_setname_np(pthread_self(), "coppice_client");
    bool uses_groot2 = options_.groot2_only;
    while (!stop_) {
      ClientSocket socket(bell_, address_, keys_ ? &*keys_ : nullptr);
      const std::unique_ptr<ClientSession> session = MakeSession(socket, uses_groot2);
      Serve(socket, *session);
      if (stop_ && session->is_live()) {
        session->Leave();
        socket.Linger();
      }
      uses_groot2 = options_.groot2_only || (session->is_wrong_protocol() && !uses_groot2);
      if (session->is_wrong_protocol() && uses_groot2) continue;
      if (!stop_) Pause(socket);
    }
    AnswerCommands(nullptr);
  }

  std::unique_ptr<ClientSession> MakeSession(ClientSocket& socket, bool uses_groot2) {
    auto sender = [&socket](const ClientSession::Parts& parts) { socket.Send(parts); };
    if (uses_groot2) {
      socket.Listen(NotificationsOf(address_));
      return std::make_unique<ClientGroot2>(options_, listener_, groot2_history_,
                                            std::move(sender));
    }
    return std::make_unique<ClientExtension>(options_, listener_, history_, std::move(sender));
  }

  // Until the connection or the client ends.
  void Serve(ClientSocket& socket, ClientSession& session) {
    const Duration start = Now();
    std::string why;
    bool was_live = false;
    while (!stop_ && session.failure().empty() && why.empty()) {
      AnswerCommands(&session);
      const Duration now = Now();
      if (!session.has_answered() && now >= start + kPatience) {
        Tell("no answer from " + endpoint_);
      }
      const Duration next = std::min(session.OnTime(now), now + kPatience);
      if (!session.failure().empty()) break;
      const ClientSocket::Event event = socket.Wait(next - now);
      if (event == ClientSocket::Event::kMessage) ReadMessages(socket, session);
      if (event == ClientSocket::Event::kGone) why = socket.problem();
      was_live = was_live || session.is_live();
    }
    if (why.empty()) why = session.failure();
    if (was_live) told_.clear();
    if (!stop_ && !session.is_wrong_protocol()) Tell(why);
    session.Abandon(why.empty() ? "the client ends" : why);
  }

  static void ReadMessages(ClientSocket& socket, ClientSession& session) {
    for (int i = 0; i < kMessagesPerRound && session.failure().empty(); ++i) {
      const ClientSocket::Parts parts = socket.Receive();
      if (parts.empty()) return;
      session.OnMessage(parts, Now());
    }
  }

  void AnswerCommands(ClientSession* session) {
    std::deque<Asked> commands;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      commands.swap(commands_);
    }
    for (Asked& asked : commands) {
      if (session && session->is_live()) {
        session->Send(asked.command, std::move(asked.on_reply));
      } else if (asked.on_reply) {
        asked.on_reply(
            Problem{"not connected to " + endpoint_ + (told_.empty() ? "" : ": " + told_)});
      }
    }
  }

  // Each problem once.
  void Tell(std::string problem) {
    if (problem.size() > kLongestProblem) problem = problem.substr(0, kLongestProblem) + "...";
    if (problem == told_) return;
    told_ = problem;
    LiveConnection connection;
    connection.problem = problem;
    listener_.OnConnection(connection);
  }

  void Pause(ClientSocket& socket) {
    const Duration end = Now() + kRetryPause;
    for (Duration now = Now(); !stop_ && now < end; now = Now()) {
      AnswerCommands(nullptr);
      socket.Wait(end - now);
      socket.Receive();
    }
  }

  const std::string endpoint_;
  const std::string address_;
  const LiveClientOptions options_;
  LiveListener& listener_;
  std::optional<WatcherKeys> keys_;
  ClientBell bell_;
  ClientHistory history_;  // of the connections of one protocol
  Groot2History groot2_history_;
  std::string told_;  // the problem that was told last
  std::atomic<bool> stop_{false};

  std::mutex mutex_;
  std::deque<Asked> commands_;

  std::thread thread_;  // last: starts when the rest is there
};

LiveClient::LiveClient(const std::string& endpoint, LiveListener& listener,
                       LiveClientOptions options)
    : loop_(std::make_unique<Loop>(endpoint, listener, std::move(options))) {}

LiveClient::~LiveClient() = default;

void LiveClient::Send(LiveCommand command, ReplyHandler on_reply) {
  loop_->Send(std::move(command), std::move(on_reply));
}

}  // namespace coppice
