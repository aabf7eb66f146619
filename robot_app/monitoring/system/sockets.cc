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

using AddressList = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

AddressList Resolve(const std::string& address, int port, int type, std::string& error) {
  addrinfo wanted{};
  wanted.ai_socktype = type;
  wanted.ai_flags = AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const int code = getaddrinfo(address.c_str(), std::to_string(port).c_str(), &wanted, &found);
  if (code != 0) error = "\"" + address + "\": " + gai_strerror(code);
  return AddressList(code == 0 ? found : nullptr, &freeaddrinfo);
}

// With the operation that makes it useful; not open, with the reason, if that fails.
template <class Operation>
Socket Open(const addrinfo& address, std::string& error, const Operation& operation) {
  Socket socket(::socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC,
                         address.ai_protocol));
  if (socket.is_open() && operation(socket.fd(), address.ai_addr, address.ai_addrlen) == 0) {
    return socket;
  }
  if (socket.is_open() && errno == EINPROGRESS) return socket;
  error = std::strerror(errno);
  return Socket();
}

Time Now() { return std::chrono::steady_clock::now().time_since_epoch(); }

}  // namespace

Socket::~Socket() {
  if (is_open()) close(fd_);
}

Socket::Socket(Socket&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

Socket& Socket::operator=(Socket&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

Socket Connect(const std::string& address, int port, int type, std::string& error) {
  const AddressList found = Resolve(address, port, type, error);
  return found ? Open(*found, error, &connect) : Socket();
}

Socket ListenUdp(const std::string& address, int port, std::string& error) {
  const AddressList found = Resolve(address, port, SOCK_DGRAM, error);
  return found ? Open(*found, error, &bind) : Socket();
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

Deadline::Deadline(Duration from_now) : time_(Now() + from_now) {}

int Deadline::milliseconds() const {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(time_ - Now()).count();
  return static_cast<int>(std::max<std::int64_t>(0, left));
}

}  // namespace coppice::robot::monitoring
