// A page over HTTP for people who need not say who they are: its files, and calls of its scripts by
// POST /call, text to text. Nothing else is served: no WebSocket, no log-in, no other program. Only
// the page's own origin may call, and only so often.
//
//   CallServer server({"127.0.0.1", 8091, folder},
//                     [&](const std::string& call) { return Reply(call); });
#ifndef COPPICE_ROBOT_APP_COMMON_WEB_CALL_SERVER_H_
#define COPPICE_ROBOT_APP_COMMON_WEB_CALL_SERVER_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace coppice::robot {

/// What the page may do in a browser: nothing but its own scripts, styles and connection.
inline constexpr const char* kCallPagePolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'";

struct CallServerOptions {
  std::string address = "127.0.0.1";  ///< as LocalAddress (bt_core/live/web/local_address.h)
  std::uint16_t port = 0;             ///< 0 takes a free one
  std::string folder;                 ///< of the page's files
  /// By which browsers may ask for it, beside addresses and names of this network (IsLocalName).
  std::string name = {};
};

class CallServer {
 public:
  static constexpr std::size_t kMostConnections = 32;
  static constexpr std::size_t kMostBodyBytes = 4 << 10;
  static constexpr int kMostCallsPerSecond = 40;  ///< of all connections together

  /// Called on the server's thread.
  using Reply = std::function<std::string(const std::string& call)>;

  /// Listens when it returns. Throws std::runtime_error, with a text for people, if the port cannot
  /// be had.
  CallServer(const CallServerOptions& options, Reply reply);
  ~CallServer();
  CallServer(const CallServer&) = delete;
  CallServer& operator=(const CallServer&) = delete;

  std::uint16_t port() const;

 private:
  class Loop;
  std::unique_ptr<Loop> loop_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_WEB_CALL_SERVER_H_
