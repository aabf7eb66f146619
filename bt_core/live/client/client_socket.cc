#include "bt_core/live/client/client_socket.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <stdexcept>
#include <system_error>

namespace coppice {
namespace {

constexpr char kDefaultPort[] = "1667";

Duration Now() { return std::chrono::steady_clock::now().time_since_epoch(); }

int Milliseconds(Duration duration) {
  constexpr auto kLongest = std::chrono::milliseconds(1000);
  const auto rounded =
      std::chrono::ceil<std::chrono::milliseconds>(std::min<Duration>(duration, kLongest));
  return static_cast<int>(std::max(std::chrono::milliseconds(0), rounded).count());
}

bool IsPort(const std::string& text) {
  unsigned port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return error == std::errc() && end == text.data() + text.size() && port > 0 && port < 65536;
}

}  // namespace

std::string AddressOf(const std::string& endpoint) {
  const std::size_t colon = endpoint.rfind(':');
  const std::string host = endpoint.substr(0, colon);
  const std::string port = colon == std::string::npos ? kDefaultPort : endpoint.substr(colon + 1);
  if (host.empty() || !IsPort(port) || host.find('/') != std::string::npos) {
    throw std::invalid_argument("\"" + endpoint +
                                "\" is no robot; expected HOST:PORT, such as localhost:1667");
  }
  return "tcp://" + host + ":" + port;
}

std::string NotificationsOf(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  return address.substr(0, colon + 1) + std::to_string(std::stoi(address.substr(colon + 1)) + 1);
}

ClientBell::ClientBell() : fd_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (fd_ < 0) throw std::system_error(errno, std::generic_category(), "live client");
}

ClientBell::~ClientBell() { close(fd_); }

void ClientBell::Ring() { eventfd_write(fd_, 1); }

bool ClientBell::TakeRing() {
  eventfd_t rings = 0;
  return eventfd_read(fd_, &rings) == 0;
}

ClientSocket::ClientSocket(ClientBell& bell, const std::string& address, const WatcherKeys* keys)
    : bell_(bell), asking_(ClientConnection::Type::kDealer, address, keys) {}

void ClientSocket::Listen(const std::string& address) {
  listening_.emplace(ClientConnection::Type::kListener, address, nullptr);
}

bool ClientSocket::HasMessage() const {
  return asking_.has_message() || (listening_ && listening_->has_message());
}

ClientSocket::Event ClientSocket::Wait(Duration at_most) {
  const Duration end = Now() + at_most;
  for (Duration now = Now(); !HasMessage(); now = Now()) {
    if (asking_.is_gone() && problem_.empty()) {
      OnGone();
      return Event::kGone;
    }
    Duration wake = std::min(end, asking_.wake());
    pollfd items[] = {{bell_.fd_, POLLIN, 0}, asking_.Wanted(), {-1, 0, 0}};
    if (listening_) {
      items[2] = listening_->Wanted();
      wake = std::min(wake, listening_->wake());
    }
    poll(items, 3, Milliseconds(wake - now));
    now = Now();
    asking_.Go(items[1].revents, now);
    if (listening_) listening_->Go(items[2].revents, now);
    if (HasMessage()) break;
    if (bell_.TakeRing()) return Event::kBell;
    if (now >= end) return Event::kTimeout;
  }
  return Event::kMessage;
}

void ClientSocket::OnGone() {
  if (asking_.was_refused()) {
    problem_ =
        "the robot sent what is no message or is too large for one beside those of other robots";
  } else if (has_received_) {
    problem_ = "the connection is closed";
  } else {
    problem_ =
        std::string("the robot closed the connection at once; perhaps it needs another token in ") +
        kTokenVariable;
  }
}

ClientSocket::Parts ClientSocket::Receive() {
  Parts parts = asking_.Receive();
  has_received_ = has_received_ || !parts.empty();
  if (parts.empty() && listening_) parts = listening_->Receive();
  if (!parts.empty() && parts.front().empty()) parts.erase(parts.begin());
  return parts;
}

void ClientSocket::Send(const Parts& parts) {
  Parts message = {""};  // as a REP awaits it
  message.insert(message.end(), parts.begin(), parts.end());
  asking_.Send(message);
}

void ClientSocket::Linger() { asking_.Finish(std::chrono::milliseconds(100)); }

}  // namespace coppice
