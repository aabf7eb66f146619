// Sockets that close themselves, and deadlines for waiting on them.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_SOCKETS_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_SOCKETS_H_

#include <string>

#include "bt_core/base/clock.h"
#include "bt_core/base/outcome.h"

namespace coppice::robot::monitoring {

class Socket {
 public:
  explicit Socket(int fd = -1) : fd_(fd) {}
  ~Socket();
  Socket(Socket&& other) noexcept;
  Socket& operator=(Socket&& other) noexcept;

  int fd() const { return fd_; }
  bool is_open() const { return fd_ >= 0; }

 private:
  int fd_;
};

/// A non-blocking socket on the way to the first address of that name; `type`: SOCK_STREAM (the
/// connection may still be under way) or SOCK_DGRAM. A name that is no numeric address is looked up
/// first, which may block for seconds.
Expected<Socket> Connect(const std::string& address, int port, int type);

/// A non-blocking UDP socket that listens there; port 0 takes a free one.
Expected<Socket> ListenUdp(const std::string& address, int port);

/// The port that a socket is bound to.
int PortOf(const Socket& socket);

/// A moment in real time.
class Deadline {
 public:
  explicit Deadline(Duration from_now);
  bool has_passed() const { return milliseconds() == 0; }
  /// Until then, rounded up, for poll.
  int milliseconds() const;

 private:
  std::chrono::steady_clock::time_point time_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_SOCKETS_H_
