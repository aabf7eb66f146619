// The two ports of a live view for clients of ZeroMQ, neighbours: requests (to clients a ROUTER,
// which looks like a REP), and notifications (a PUB).
//
// A thread of its own reads what strangers send; what is no request of a client that may connect
// ends there. Limits: time until a client has said who it is, connections, bytes of a message, and
// those of LiveClients.
#ifndef COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_GATEWAY_H_
#define COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_GATEWAY_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "bt_core/live/server/live_clients.h"
#include "bt_core/live/server/token_keys.h"

namespace coppice {

class ZmtpGateway {
 public:
  /// Of each of the ports.
  static constexpr std::size_t kMaxConnections = 128;

  /// Binds `port` for requests and port + 1 for notifications; 0 takes a free pair. With keys,
  /// nobody else can connect. Listens when it returns. Throws std::runtime_error with one line that
  /// names the port and says what to do. `clients` must live longer.
  ZmtpGateway(const std::string& address, std::uint16_t port, std::optional<RobotKeys> keys,
              LiveClients& clients);
  /// Stops, and clears `clients`: those of other gateways must be stopped too.
  ~ZmtpGateway();
  ZmtpGateway(const ZmtpGateway&) = delete;
  ZmtpGateway& operator=(const ZmtpGateway&) = delete;

  /// What was sent still goes out, for at most 200 ms; then nobody is served any more.
  void Stop();

  /// Where requests are served.
  std::uint16_t port() const;

 private:
  class Loop;

  std::unique_ptr<Loop> loop_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_GATEWAY_H_
