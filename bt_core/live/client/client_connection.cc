#include "bt_core/live/client/client_connection.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <utility>

#include "bt_core/frames/frame.h"

namespace coppice {
namespace {

using zmtp::ZmtpClient;

constexpr Duration kReconnectPause = std::chrono::milliseconds(50);
constexpr Duration kConnectPatience = std::chrono::seconds(2);     // for each address
constexpr Duration kHandshakePatience = std::chrono::seconds(5);   // then it is tried again
constexpr std::size_t kMaxMessage = kMaxPayloadSize + (64 << 10);  // a frame of a history, and more
constexpr std::size_t kMaxNotification = 64 << 10;
constexpr std::size_t kMaxUnsent = 16 << 20;
constexpr std::size_t kMaxWaiting = 1000;  // messages

constexpr std::size_t kSchemeSize = sizeof("tcp://") - 1;

std::string HostOf(const std::string& address) {
  return address.substr(kSchemeSize, address.rfind(':') - kSchemeSize);
}

std::string PortOf(const std::string& address) { return address.substr(address.rfind(':') + 1); }

void SetOption(int fd, int level, int name) {
  const int on = 1;
  setsockopt(fd, level, name, &on, sizeof(on));
}

bool IsForLater(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

Duration Now() { return std::chrono::steady_clock::now().time_since_epoch(); }

}  // namespace

ClientConnection::ClientConnection(Type type, const std::string& address, const WatcherKeys* keys)
    : type_(type), host_(HostOf(address)), port_(PortOf(address)), keys_(keys) {}

pollfd ClientConnection::Wanted() const {
  switch (state_) {
    case State::kLooking:
      return {lookup_->fd(), POLLIN, 0};
    case State::kConnecting:
      return {fd_, POLLOUT, 0};
    case State::kTalking: {
      const int in = message_ ? 0 : POLLIN;
      const int out = unsent_.empty() ? 0 : POLLOUT;
      // An end that is not asked for would wake who waits again and again.
      return {in | out ? fd_ : -1, static_cast<short>(in | out), 0};
    }
    default:
      return {-1, 0, 0};
  }
}

void ClientConnection::Go(short events, Duration now) {
  const bool is_late = now >= wake_;
  switch (state_) {
    case State::kPausing:
      if (is_late) Look(now);
      break;
    case State::kLooking:
      if (!events) break;
      addresses_ = lookup_->Take();
      lookup_.reset();
      next_address_ = 0;
      ConnectToNext(now);
      break;
    case State::kConnecting:
      if (events) {
        OnConnected(now);
      } else if (is_late) {
        ConnectToNext(now);
      }
      break;
    case State::kTalking:
      if (is_late && !peer_->is_open()) return Pause(now);
      if (!unsent_.empty()) Write();
      if (events & (POLLIN | POLLHUP | POLLERR)) Read();
      break;
    case State::kGone:
      if (type_ == Type::kListener) Pause(now);
      break;
  }
}

void ClientConnection::Look(Duration now) {
  lookup_.emplace(host_, port_);
  if (lookup_->fd() < 0) return Pause(now);  // no descriptor is left for now
  state_ = State::kLooking;
  wake_ = Duration::max();
}

void ClientConnection::ConnectToNext(Duration now) {
  for (Close(); next_address_ < addresses_.size(); Close()) {
    const NetworkAddress& address = addresses_[next_address_++];
    fd_ = socket(address.address.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (fd_ < 0) continue;
    const auto* const place = reinterpret_cast<const sockaddr*>(&address.address);
    if (connect(fd_, place, address.size) != 0 && errno != EINPROGRESS) continue;
    state_ = State::kConnecting;
    wake_ = now + kConnectPatience;
    return;
  }
  Pause(now);
}

void ClientConnection::OnConnected(Duration now) {
  int error = 0;
  socklen_t size = sizeof(error);
  if (getsockopt(fd_, SOL_SOCKET, SO_ERROR, &error, &size) != 0 || error != 0) {
    return ConnectToNext(now);
  }
  SetOption(fd_, IPPROTO_TCP, TCP_NODELAY);
  SetOption(fd_, SOL_SOCKET, SO_KEEPALIVE);
  state_ = State::kTalking;
  wake_ = now + kHandshakePatience;
  peer_.emplace(type_, keys_, type_ == Type::kDealer ? kMaxMessage : kMaxNotification);
  unsent_ = peer_->TakeOutput();
  Write();
}

void ClientConnection::Read() {
  if (state_ != State::kTalking || message_) return;
  std::array<char, 64 << 10> buffer;
  const ssize_t size = recv(fd_, buffer.data(), buffer.size(), 0);
  if (size < 0 && IsForLater(errno)) return;
  if (size <= 0) return Lose();
  peer_->Receive({buffer.data(), static_cast<std::size_t>(size)});
  Advance();
}

void ClientConnection::Advance() {
  Parts message;
  const auto step = peer_->Next(message);
  const std::string output = peer_->TakeOutput();
  if (unsent_.size() < kMaxUnsent) unsent_ += output;  // not for who does not read
  if (peer_->is_open()) {
    wake_ = Duration::max();
    for (const Parts& parts : std::exchange(waiting_, {})) unsent_ += peer_->Encode(parts);
  }
  std::size_t bytes = peer_->come();
  for (const std::string& part : message) bytes += part.size();
  const bool is_refused = step == ZmtpClient::Step::kRefused || !room_.Hold(bytes);
  if (step == ZmtpClient::Step::kMessage && !is_refused) message_ = std::move(message);
  Write();
  if (!is_refused) return;
  was_refused_ = peer_->is_open();
  Lose();
}

void ClientConnection::Write() {
  while (state_ == State::kTalking && sent_ < unsent_.size()) {
    const ssize_t size = send(fd_, unsent_.data() + sent_, unsent_.size() - sent_, MSG_NOSIGNAL);
    if (size < 0 && IsForLater(errno)) return;
    if (size < 0) break;  // it is gone; what it said last is read first
    sent_ += static_cast<std::size_t>(size);
  }
  unsent_.clear();
  sent_ = 0;
}

ClientConnection::Parts ClientConnection::Receive() {
  Read();
  if (!message_) return {};
  Parts parts = *std::exchange(message_, std::nullopt);
  room_.Hold(0);
  if (state_ == State::kTalking) Advance();
  return parts;
}

void ClientConnection::Send(const Parts& parts) {
  if (state_ == State::kGone) return;
  if (state_ != State::kTalking || !peer_->is_open()) {
    if (waiting_.size() < kMaxWaiting) waiting_.push_back(parts);
    return;
  }
  if (unsent_.size() >= kMaxUnsent) return;
  unsent_ += peer_->Encode(parts);
  Write();
}

// Who closes what has not been read takes back what was sent last.
void ClientConnection::Finish(Duration at_most) {
  const Duration end = Now() + at_most;
  bool has_ended = false;
  for (Duration now = Now(); state_ == State::kTalking && now < end; now = Now()) {
    if (unsent_.empty() && !std::exchange(has_ended, true)) shutdown(fd_, SHUT_WR);
    pollfd item = {fd_, static_cast<short>(has_ended ? POLLIN : POLLOUT), 0};
    poll(&item, 1,
         static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(end - now).count()));
    if (!has_ended) {
      Write();
      continue;
    }
    std::array<char, 64 << 10> unread;
    const ssize_t size = recv(fd_, unread.data(), unread.size(), 0);
    if (size == 0 || (size < 0 && !IsForLater(errno))) return;
  }
}

void ClientConnection::Pause(Duration now) {
  Close();
  state_ = State::kPausing;
  wake_ = now + kReconnectPause;
}

void ClientConnection::Lose() {
  Close();
  state_ = State::kGone;
  wake_ = type_ == Type::kListener ? Duration(0) : Duration::max();
}

void ClientConnection::Close() {
  if (fd_ >= 0) close(fd_);
  fd_ = -1;
  if (!message_) room_.Hold(0);
  unsent_.clear();
  sent_ = 0;
}

}  // namespace coppice
