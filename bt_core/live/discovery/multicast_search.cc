#include "bt_core/live/discovery/multicast_search.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <csignal>
#include <list>
#include <mutex>
#include <random>
#include <thread>
#include <utility>

#include "bt_core/live/discovery/found_robots.h"
#include "bt_core/live/discovery/multicast_socket.h"

namespace coppice {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

constexpr std::chrono::seconds kFirstPause{1};
constexpr std::chrono::seconds kLongestPause{8};
constexpr int kHeardOfAQuestion = 256;  // in each network

}  // namespace

class MulticastSearch::Loop {
 public:
  Loop(std::function<void()> wake, std::string address)
      : wake_(std::move(wake)), address_(std::move(address)), thread_([this] { Run(); }) {}

  ~Loop() {
    context_.stop();
    thread_.join();
  }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  std::vector<FoundRobot> Look() {
    if (!is_wanted_.exchange(true)) asio::post(context_, [this] { Begin(); });
    has_news_ = false;
    const std::lock_guard<std::mutex> lock(mutex_);
    return list_;
  }

  void Rest() {
    if (is_wanted_.exchange(false)) asio::post(context_, [this] { End(); });
  }

  bool has_news() const { return has_news_; }

 private:
  void Run() {
    pthread_setname_np(pthread_self(), "coppice_search");
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    const auto work = asio::make_work_guard(context_);
    context_.run();
  }

  // It may have been told to rest since.
  void Begin() {
    if (!is_wanted_) return;
    pause_ = kFirstPause;
    Ask();
  }

  void End() {
    if (is_wanted_) return;
    timer_.cancel();
    sockets_.clear();
  }

  void Ask() {
    LookAround();
    if (found_.Ask()) TellNews();
    id_ = static_cast<std::uint16_t>(random_());
    for (MulticastSocket& socket : sockets_) {
      socket.Hear(kHeardOfAQuestion);
      socket.SendToAll(QuestionMessage(id_));
    }
    timer_.expires_after(pause_);
    timer_.async_wait([this](error_code cancelled) {
      if (!cancelled && is_wanted_) Ask();
    });
    pause_ = std::min(2 * pause_, kLongestPause);
  }

  void LookAround() {
    const std::vector<NetworkInterface> there = InterfacesOf(address_);
    sockets_.remove_if([&](const MulticastSocket& socket) {
      return !socket.is_good() ||
             std::find(there.begin(), there.end(), socket.interface()) == there.end();
    });
    for (const NetworkInterface& one : there) {
      const bool is_new =
          std::none_of(sockets_.begin(), sockets_.end(),
                       [&](const MulticastSocket& has) { return has.interface() == one; });
      if (is_new) Join(one);
    }
  }

  // Without that network there are fewer robots, and that is all.
  void Join(const NetworkInterface& interface) {
    try {
      sockets_.emplace_back(context_, interface, MulticastSocket::Kind::kAsks,
                            [this](std::string_view message,
                                   const MulticastSocket::Endpoint& from) { Hear(message, from); });
    } catch (const boost::system::system_error&) {
      return;
    }
  }

  // Answers come from the port of multicast DNS; RFC 6762, 6.
  void Hear(std::string_view message, const MulticastSocket::Endpoint& from) {
    if (from.port() != MulticastSocket::kPort) return;
    bool is_news = false;
    for (const RobotNotice& notice : ReadAnswer(message, id_)) {
      is_news |= found_.Hear(from.address().to_v4().to_bytes(), notice);
    }
    if (is_news) TellNews();
  }

  void TellNews() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      list_ = found_.List();
    }
    has_news_ = true;
    if (wake_) wake_();
  }

  const std::function<void()> wake_;
  const std::string address_;
  std::atomic<bool> is_wanted_{false};
  std::atomic<bool> has_news_{false};
  std::mutex mutex_;
  std::vector<FoundRobot> list_;

  asio::io_context context_;
  asio::steady_timer timer_{context_};
  std::list<MulticastSocket> sockets_;
  FoundRobots found_;
  std::random_device random_;
  std::uint16_t id_ = 0;
  std::chrono::seconds pause_ = kFirstPause;
  std::thread thread_;
};

MulticastSearch::MulticastSearch(std::function<void()> wake, const std::string& address)
    : loop_(std::make_unique<Loop>(std::move(wake), address)) {}

MulticastSearch::~MulticastSearch() = default;

std::vector<FoundRobot> MulticastSearch::Look() { return loop_->Look(); }
void MulticastSearch::Rest() { loop_->Rest(); }
bool MulticastSearch::has_news() const { return loop_->has_news(); }

}  // namespace coppice
