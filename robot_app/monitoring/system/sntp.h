// How far the clocks of other computers are from ours: the client of the Simple Network Time
// Protocol (RFC 5905, section 14), which every NTP server answers.
//
//   our clock:   t1 request sent ........ t4 reply received
//   its clock:        t2 received, t3 sent
//   offset = ((t2 - t1) + (t3 - t4)) / 2     (section 8; wrong by at most half the round trip)
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_SNTP_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_SNTP_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/outcome.h"

namespace coppice::robot::monitoring {

/// Seconds since 1900 in 32.32 fixed point, as NTP sends them; wraps in 2036, which differences
/// survive.
using NtpTime = std::uint64_t;

NtpTime ToNtp(WallTime time);
/// later - earlier in seconds, between -2^31 and 2^31.
double NtpSeconds(NtpTime later, NtpTime earlier);

/// The fields that a client needs (section 7.3).
struct NtpPacket {
  static constexpr std::size_t kSize = 48;
  using Bytes = std::array<std::uint8_t, kSize>;

  enum Mode : std::uint8_t { kClient = 3, kServer = 4 };
  static constexpr std::uint8_t kNotSynchronized = 3;  // leap indicator

  std::uint8_t leap = 0;
  Mode mode = kClient;
  std::uint8_t stratum = 0;  ///< 0: the server does not want to be asked ("kiss of death")
  NtpTime origin = 0;        ///< t1, as the client sent it
  NtpTime receive = 0;       ///< t2
  NtpTime transmit = 0;      ///< t3; of a request: t1

  Bytes Encode() const;
  /// Nothing if it is too short.
  static std::optional<NtpPacket> Decode(const std::uint8_t* data, std::size_t size);
};

/// What a clock said.
struct ClockReading {
  double offset = 0;  ///< s, its clock less ours
  double delay = 0;   ///< s, of the way there and back
};

/// Judges the reply to a request that was sent at t1 and received at t4.
Expected<ClockReading> ReadReply(const NtpPacket& reply, NtpTime t1, NtpTime t4);

struct ClockServer {
  std::string address;  ///< a name or a numeric address
  int port = 123;
};

/// Asks all at the same time; blocks until all have answered or the deadline has passed (the
/// resolution of names takes its own time). For any thread.
std::vector<Expected<ClockReading>> QueryClocks(const std::vector<ClockServer>& servers,
                                                Duration deadline);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_SNTP_H_
