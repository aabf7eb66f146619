#include "robot_app/monitoring/system/sockets.h"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

namespace coppice::robot::monitoring {
namespace {

using SteadyClock = std::chrono::steady_clock;

using AddressList = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

Expected<AddressList> Resolve(const std::string& address, int port, int type) {
  addrinfo wanted{};
  wanted.ai_socktype = type;
  wanted.ai_flags = AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const int code = getaddrinfo(address.c_str(), std::to_string(port).c_str(), &wanted, &found);
  if (code != 0) return Problem{"\"" + address + "\": " + gai_strerror(code)};
  return AddressList(found, &freeaddrinfo);
}

// With the operation that makes it useful.
template <class Operation>
Expected<Socket> Open(const Expected<AddressList>& found, const Operation& operation) {
  if (!found) return Problem{found.problem()};
  const addrinfo& address = **found;
  Socket socket(::socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC,
                         address.ai_protocol));
  if (socket.is_open() && operation(socket.fd(), address.ai_addr, address.ai_addrlen) == 0) {
    return socket;
  }
  if (socket.is_open() && errno == EINPROGRESS) return socket;
  return Problem{std::strerror(errno)};
}

}  // namespace

Socket::~Socket() {
  if (is_open()) close(fd_);
}

Socket::Socket(Socket&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

Socket& Socket::operator=(Socket&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

Expected<Socket> Connect(const std::string& address, int port, int type) {
  return Open(Resolve(address, port, type), &connect);
}

Expected<Socket> ListenUdp(const std::string& address, int port) {
  return Open(Resolve(address, port, SOCK_DGRAM), &bind);
}

int PortOf(const Socket& socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof(address);
  if (getsockname(socket.fd(), reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  if (address.ss_family == AF_INET6) {
    return ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port);
  }
  return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

Deadline::Deadline(Duration from_now) : time_(SteadyClock::now() + from_now) {}

int Deadline::milliseconds() const {
  const auto left =
      std::chrono::ceil<std::chrono::milliseconds>(time_ - SteadyClock::now()).count();
  return static_cast<int>(std::max<std::int64_t>(0, left));
}

}  // namespace coppice::robot::monitoring
