// The web side of a live view: one port that serves the page of the editor over HTTP and carries
// the messages of the live protocol over WebSocket (RFC 6455).
//
//   WebGateway gateway(options, [&] { loop.Wake(); });
//   while (gateway.Receive(request)) desk.Serve(request.client, ...);
//
// It has a thread of its own, in which it reads what strangers send; what is no request of the
// protocol ends there. A client that does not read is told from one that has gone, as at the live
// socket, and one whose next request was not taken yet is not listened to.
#ifndef COPPICE_BT_CORE_LIVE_WEB_WEB_GATEWAY_H_
#define COPPICE_BT_CORE_LIVE_WEB_WEB_GATEWAY_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "bt_core/live/server/live_outbox.h"
#include "bt_core/live/server/received_request.h"
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
  static constexpr std::size_t kMaxConnections = 64;
  static constexpr std::size_t kMaxHeaderBytes = 8 << 10;
  static constexpr std::size_t kMaxRequestBytes = 1 << 20;
  /// What may wait for a client that does not read: one message, and as many as fit into this.
  static constexpr std::size_t kMaxUnreadBytes = 4 << 20;

  /// Listens when it returns. `on_request` is called on the gateway's thread when Receive has
  /// something new. Throws std::runtime_error, with a text for people, if the port cannot be had.
  WebGateway(const WebGatewayOptions& options, std::function<void()> on_request);
  /// What was sent still goes out, for at most 200 ms.
  ~WebGateway();
  WebGateway(const WebGateway&) = delete;
  WebGateway& operator=(const WebGateway&) = delete;

  std::uint16_t port() const;

  /// Any thread. False if there is no request now. The end of a connection is a request to say bye.
  bool Receive(ReceivedRequest& request);

  /// Any thread. Never waits.
  SendResult Send(const std::string& client, const groot2::Parts& parts);

  /// Whether the name is of a client that came through a gateway.
  static bool IsWebClient(const std::string& client);

 private:
  class Loop;

  std::unique_ptr<Loop> loop_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_WEB_WEB_GATEWAY_H_
