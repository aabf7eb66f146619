// Whom the web side of a live view lets in: decides by what a browser says when it asks for a
// WebSocket. Knows no sockets.
//
// Without tokens the rule is that of the live socket: programs of this computer. But a browser runs
// programs of other people too, with each page that it shows; so what bears an Origin must be our
// own page (RFC 6454, RFC 6455 section 10.2), under a name that can be nobody else's, or else a
// foreign name server could make its own name mean this computer.
#ifndef COPPICE_BT_CORE_LIVE_WEB_WEB_ACCESS_H_
#define COPPICE_BT_CORE_LIVE_WEB_WEB_ACCESS_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "bt_core/base/outcome.h"

namespace coppice {

/// The WebSocket subprotocol that both sides name.
inline constexpr const char* kWebProtocol = "coppice-live";
/// Stands before the token in the list of subprotocols; a browser can send it nowhere else.
inline constexpr const char* kWebTokenPrefix = "token.";

/// Empty: none is needed.
struct WebTokens {
  std::string control;
  std::string read;
};

enum class WebRole : std::uint8_t { kRead, kControl };

/// Header fields of the request; empty if they are not there.
struct WebVisitor {
  std::string_view host;
  std::string_view origin;
  std::string_view protocols;  ///< Sec-WebSocket-Protocol
};

/// Whether the page that a browser asks from (header field Origin) came from where it asks (Host).
bool IsOwnPage(std::string_view origin, std::string_view host);

/// Whether a page under this name (Host) can be nobody else's: an address, or a name that is not
/// asked of the name servers of the world (without a dot, or that ends in .local). Of any other,
/// whoever owns it can say that it means this computer, and his page is then of the same origin.
bool IsLocalName(std::string_view host);

class WebAccess {
 public:
  explicit WebAccess(WebTokens tokens = {}) : tokens_(std::move(tokens)) {}

  /// As what the visitor is let in.
  Expected<WebRole> Judge(const WebVisitor& visitor) const;

  const WebTokens& tokens() const { return tokens_; }

 private:
  const WebTokens tokens_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_WEB_WEB_ACCESS_H_
