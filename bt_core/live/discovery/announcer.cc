#include "bt_core/live/discovery/announcer.h"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cctype>
#include <chrono>
#include <csignal>
#include <list>
#include <random>
#include <stdexcept>
#include <thread>
#include <utility>

#include "bt_core/live/discovery/multicast_socket.h"

namespace coppice {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

constexpr auto kBeat = std::chrono::seconds(1);
constexpr int kBeatsToLook = 5;    // between two looks at the networks
constexpr int kAnnouncements = 2;  // of what is new, a beat apart; RFC 6762, 8.3
constexpr int kHeardInABeat = 200;
constexpr int kAnswersInABeat = 20;

// Programs of this computer hear it in any of them: the one that it has with itself is for a robot
// that has no other.
std::vector<NetworkInterface> NetworksOf(const std::string& address) {
  std::vector<NetworkInterface> found = InterfacesOf(address);
  const auto own = std::remove_if(found.begin(), found.end(), [](const NetworkInterface& one) {
    return one.address.front() == 127;
  });
  if (own != found.begin()) found.erase(own, found.end());
  return found;
}

// The robot in one network.
class Presence {
 public:
  Presence(asio::io_context& context, const NetworkInterface& interface, const RobotNotice& robot)
      : robot_(robot),
        socket_(context, interface, MulticastSocket::Kind::kAnswers,
                [this](std::string_view message, const MulticastSocket::Endpoint& from) {
                  Answer(message, from);
                }) {}

  const NetworkInterface& interface() const { return socket_.interface(); }
  bool is_good() const { return socket_.is_good(); }
  void TellNews() { announcements_ = kAnnouncements; }

  void Beat() {
    answers_ = kAnswersInABeat;
    socket_.Hear(kHeardInABeat);
    may_announce_ = true;
    if (announcements_ > 0) Announce();
  }
  void Leave() { socket_.SendToAll(AnnouncementMessage(robot_, interface().address, true)); }

 private:
  void Answer(std::string_view message, const MulticastSocket::Endpoint& from) {
    const std::optional<RobotQuestion> question = ReadQuestion(message, robot_);
    if (!question || answers_ == 0) return;
    --answers_;
    if (from.port() != MulticastSocket::kPort) {
      return socket_.SendTo(AnswerMessage(robot_, interface().address, *question), from);
    }
    announcements_ = std::max(announcements_, 1);
    if (may_announce_) Announce();
  }

  // Not more often than each second; RFC 6762, 6.
  void Announce() {
    may_announce_ = false;
    --announcements_;
    socket_.SendToAll(AnnouncementMessage(robot_, interface().address));
  }

  const RobotNotice& robot_;
  int announcements_ = kAnnouncements;  // that are left
  int answers_ = 0;                     // likewise, in this beat
  bool may_announce_ = false;
  MulticastSocket socket_;
};

}  // namespace

class Announcer::Loop {
 public:
  Loop(std::string address, RobotNotice robot)
      : address_(std::move(address)), robot_(std::move(robot)) {
    LookAround();
    if (presences_.empty() && !why_not_.empty()) {
      throw std::runtime_error("cannot announce the robot on " + address_ + ": " + why_not_);
    }
    Beat();
    thread_ = std::thread([this] { Run(); });
  }

  ~Loop() {
    asio::post(context_, [this] {
      for (Presence& presence : presences_) presence.Leave();
      context_.stop();
    });
    thread_.join();
  }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  void SetTree(const std::string& tree) {
    asio::post(context_, [this, tree] {
      if (robot_.tree == tree) return;
      robot_.tree = tree;
      for (Presence& presence : presences_) presence.TellNews();
    });
  }

 private:
  void Run() {
    pthread_setname_np(pthread_self(), "coppice_announc");
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    context_.run();
  }

  void Beat() {
    if (++beats_ % kBeatsToLook == 0) LookAround();
    for (Presence& presence : presences_) presence.Beat();
    timer_.expires_after(kBeat);
    timer_.async_wait([this](error_code) { Beat(); });
  }

  // Networks come and go: a wireless one is there long after the robot was started.
  void LookAround() {
    const std::vector<NetworkInterface> there = NetworksOf(address_);
    presences_.remove_if([&](const Presence& presence) {
      return !presence.is_good() ||
             std::find(there.begin(), there.end(), presence.interface()) == there.end();
    });
    for (const NetworkInterface& one : there) {
      const bool is_new = std::none_of(presences_.begin(), presences_.end(),
                                       [&](const Presence& has) { return has.interface() == one; });
      if (is_new) Join(one);
    }
  }

  void Join(const NetworkInterface& interface) {
    try {
      presences_.emplace_back(context_, interface, robot_);
    } catch (const boost::system::system_error& error) {
      why_not_ = error.code().message();
    }
  }

  const std::string address_;
  RobotNotice robot_;
  std::string why_not_;
  int beats_ = 0;
  asio::io_context context_;
  asio::steady_timer timer_{context_};
  std::list<Presence> presences_;
  std::thread thread_;
};

Announcer::Announcer(const std::string& address, RobotNotice robot)
    : loop_(std::make_unique<Loop>(address, std::move(robot))) {}

Announcer::~Announcer() = default;

void Announcer::SetTree(const std::string& tree) { loop_->SetTree(tree); }

RobotNotice NoticeOfThisRobot(std::uint16_t port, bool needs_token) {
  char host[256] = {};
  gethostname(host, sizeof(host) - 1);
  RobotNotice robot;
  robot.host = host;
  robot.port = port;
  robot.needs_token = needs_token;
  for (const char* at = host; *at != '\0' && *at != '.' && robot.label.size() < 40; ++at) {
    robot.label += std::isalnum(static_cast<unsigned char>(*at)) != 0 ? *at : '-';
  }
  if (robot.label.empty()) robot.label = "robot";
  robot.label += "-" + std::to_string(port) + "-" + std::to_string(std::random_device()());
  return robot;
}

}  // namespace coppice
