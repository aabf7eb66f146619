#include "bt_core/live/server/live_server.h"

#include <pthread.h>

#include <algorithm>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "bt_core/base/wake_up.h"
#include "bt_core/live/discovery/announcer.h"
#include "bt_core/live/server/live_clients.h"
#include "bt_core/live/server/live_desk.h"
#include "bt_core/live/web/web_gateway.h"
#include "bt_core/live/zmtp/zmtp_gateway.h"

namespace coppice {
namespace {

constexpr int kRequestsAtOnce = 64;                        // before pushes have their turn
constexpr Duration kPause = std::chrono::milliseconds(1);  // between pushes: many ticks in each

Duration RealTime() { return std::chrono::steady_clock::now().time_since_epoch(); }

bool IsThisComputer(const std::string& address) {
  return address.substr(0, 4) == "127." || address == "lo";
}

std::optional<RobotKeys> KeysFor(const LiveOptions& options) {
  if (!options.token.empty()) return KeysOfRobot(options.token);
  if (IsThisComputer(options.address)) return std::nullopt;
  throw std::invalid_argument(
      "live view: whoever reaches " + options.address +
      " could stop the robot. Listening there needs a token: make one with \"openssl rand -hex "
      "16\" and put it into the variable " +
      kTokenVariable + "; or listen on 127.0.0.1 and let others come through SSH");
}

WebGatewayOptions WebOptions(const LiveOptions& options, const std::optional<RobotKeys>& keys) {
  WebGatewayOptions web;
  web.address = options.address;
  web.port = options.web_port;
  web.folder = options.web_folder;
  if (keys) web.tokens = {keys->web_control_token, keys->web_read_token};
  return web;
}

// Null if nobody is told.
std::unique_ptr<Announcer> Announce(const LiveOptions& options, std::uint16_t port) {
  if (!options.announce) return nullptr;
  return std::make_unique<Announcer>(options.address,
                                     NoticeOfThisRobot(port, !options.token.empty()));
}

// The ways in.
class Doors {
 public:
  Doors(const LiveOptions& options, const std::optional<RobotKeys>& keys, LiveClients& clients)
      : read_token_(keys ? keys->read_token : std::string()),
        zmtp_(options.address, options.port, keys, clients) {
    if (!options.web) return;
    const WebGatewayOptions web = WebOptions(options, keys);
    gateway_.emplace(web, clients);
    web_ = {gateway_->port(), web.tokens.control, web.tokens.read};
  }
  // Both, before the clients are cleared.
  ~Doors() {
    zmtp_.Stop();
    if (gateway_) gateway_->Stop();
  }
  Doors(const Doors&) = delete;
  Doors& operator=(const Doors&) = delete;

  std::uint16_t port() const { return zmtp_.port(); }
  const std::string& read_token() const { return read_token_; }
  const LiveWeb& web() const { return web_; }

 private:
  const std::string read_token_;
  ZmtpGateway zmtp_;
  std::optional<WebGateway> gateway_;
  LiveWeb web_;
};

}  // namespace

class LiveServer::Loop {
 public:
  Loop(const LiveOptions& options, const std::optional<RobotKeys>& keys)
      : doors_(options, keys, clients_),
        desk_(clients_, options.deadline, options.pictures),
        announcer_(Announce(options, doors_.port())),
        thread_([this] { Run(); }) {}

  ~Loop() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      stops_ = true;
    }
    Wake();
    thread_.join();
  }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  std::uint16_t port() const { return doors_.port(); }
  const std::string& read_token() const { return doors_.read_token(); }
  const LiveWeb& web() const { return doors_.web(); }
  void Wake() { wake_up_.Notify(); }

  void Add(std::shared_ptr<LiveTree> tree) {
    InLoop([this, tree = std::move(tree)] {
      desk_.Add(tree, RealTime());
      TellFirstTree();
    });
  }
  void Remove(const std::shared_ptr<LiveTree>& tree) {
    InLoop([this, tree] {
      desk_.Remove(*tree);
      TellFirstTree();
    });
  }

 private:
  // The desk belongs to the thread of the loop; returns when it has done the task.
  void InLoop(std::function<void()> task) {
    std::unique_lock<std::mutex> lock(mutex_);
    done_.wait(lock, [this] { return !task_; });
    task_ = std::move(task);
    const std::uint64_t number = ++tasks_;
    Wake();
    done_.wait(lock, [this, number] { return tasks_done_ >= number; });
  }

  void TellFirstTree() {
    if (announcer_) announcer_->SetTree(desk_.first_tree());
  }

  void Run() {
    pthread_setname_np(pthread_self(), "coppice_live");
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    Duration attend_at{0};
    while (RunTask()) {
      if (!ServeRequests()) wake_up_.WaitFor(attend_at - RealTime());
      attend_at = Attend();
    }
  }

  // False when the loop is to end.
  bool RunTask() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (task_) {
      task_();
      task_ = nullptr;
      ++tasks_done_;
      done_.notify_all();
    }
    return !stops_;
  }

  // True if there may be more.
  bool ServeRequests() {
    ReceivedRequest request;
    for (int served = 0; served < kRequestsAtOnce; ++served) {
      if (!clients_.Receive(request)) return false;
      desk_.Serve(request.client, request.may_control, request.parts, request.arrived);
    }
    return true;
  }

  // A wake that comes too soon after the last push is put off.
  Duration Attend() {
    const Duration now = RealTime();
    if (now < last_push_ + kPause) return last_push_ + kPause;
    last_push_ = now;
    return desk_.Attend(now, clients_.HeardUntil(now));
  }

  WakeUp wake_up_;
  LiveClients clients_{[this] { Wake(); }};
  Doors doors_;
  LiveDesk desk_;
  const std::unique_ptr<Announcer> announcer_;
  Duration last_push_{0};

  std::mutex mutex_;
  std::condition_variable done_;
  std::function<void()> task_;
  std::uint64_t tasks_ = 0;
  std::uint64_t tasks_done_ = 0;
  bool stops_ = false;
  std::thread thread_;  // last: starts when the rest is there
};

LiveServer::LiveServer(const LiveOptions& options)
    : loop_(std::make_unique<Loop>(options, KeysFor(options))) {}

LiveServer::~LiveServer() = default;

std::uint16_t LiveServer::port() const { return loop_->port(); }
const std::string& LiveServer::read_token() const { return loop_->read_token(); }
const LiveWeb& LiveServer::web() const { return loop_->web(); }
void LiveServer::Add(std::shared_ptr<LiveTree> tree) { loop_->Add(std::move(tree)); }
void LiveServer::Remove(const std::shared_ptr<LiveTree>& tree) { loop_->Remove(tree); }
void LiveServer::Wake() { loop_->Wake(); }

}  // namespace coppice
