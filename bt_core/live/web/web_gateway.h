// The web side of a live view: one port that serves the page of the editor over HTTP and carries
// the messages of the live protocol over WebSocket (RFC 6455).
//
// It has a thread of its own, in which it reads what strangers send; what is no request of the
// protocol ends there.
#ifndef COPPICE_BT_CORE_LIVE_WEB_WEB_GATEWAY_H_
#define COPPICE_BT_CORE_LIVE_WEB_WEB_GATEWAY_H_

#include <cstdint>
#include <memory>
#include <string>

#include "bt_core/live/server/live_clients.h"
#include "bt_core/live/web/web_access.h"

namespace coppice {

struct WebGatewayOptions {
  std::string address;     ///< as LiveOptions::address
  std::uint16_t port = 0;  ///< 0 takes a free one
  WebTokens tokens;
  std::string folder;  ///< of the page
};

class WebGateway {
 public:
  static constexpr std::size_t kMaxConnections = 256;
  static constexpr std::size_t kMaxHeaderBytes = 8 << 10;

  /// Listens when it returns. Throws std::runtime_error, with a text for people, if the port cannot
  /// be had. `clients` must live longer.
  WebGateway(const WebGatewayOptions& options, LiveClients& clients);
  /// Stops, and clears `clients`: those of other gateways must be stopped too.
  ~WebGateway();
  WebGateway(const WebGateway&) = delete;
  WebGateway& operator=(const WebGateway&) = delete;

  /// What was sent still goes out, for at most 200 ms; then nobody is served any more.
  void Stop();

  std::uint16_t port() const;

 private:
  class Loop;

  std::unique_ptr<Loop> loop_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_WEB_WEB_GATEWAY_H_
