// Answers SNTP requests with this computer's clock (RFC 5905, section 14): for networks without
// an NTP server, and for tests.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_TIME_SERVER_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_TIME_SERVER_H_

#include <string>

#include "robot_app/monitoring/system/sntp.h"
#include "robot_app/monitoring/system/sockets.h"

namespace coppice::robot::monitoring {

/// The answer to a request that came at that time. The server calls itself of stratum 10: better
/// than nothing, worse than any server that is itself synchronized.
NtpPacket AnswerOf(const NtpPacket& request, NtpTime received_at, NtpTime now);

/// For one thread.
class TimeServer {
 public:
  /// `address`: where it listens; port 0 takes a free one. `clock_offset`: added to the clock, to
  /// try what happens when a clock is wrong.
  TimeServer(const std::string& address, int port, Duration clock_offset);

  /// Empty: it listens. Else why not.
  const std::string& error() const { return socket_.problem(); }
  /// It must listen.
  int port() const { return PortOf(*socket_); }

  /// Waits for requests for at most this long and answers them.
  void Work(Duration at_most);

 private:
  void Answer();

  Duration clock_offset_;
  Expected<Socket> socket_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_TIME_SERVER_H_
