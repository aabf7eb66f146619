// Clients of a live view for tests: one that asks as any client of the Groot2 protocol does, and
// one that speaks the extension.
#ifndef COPPICE_TESTS_BT_CORE_LIVE_LIVE_CLIENT_H_
#define COPPICE_TESTS_BT_CORE_LIVE_LIVE_CLIENT_H_

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>
#include <zmq.hpp>

#include "bt_core/live/server/live_options.h"
#include "bt_core/live/server/token_keys.h"

namespace coppice {

using Parts = std::vector<std::string>;

inline LiveOptions FreePort() {
  LiveOptions options;
  options.port = 0;
  return options;
}

class SocketClient {
 public:
  SocketClient(zmq::socket_type type, std::uint16_t port, const std::string& token = {},
               const std::string& identity = {})
      : socket_(context_, type) {
    if (!identity.empty()) socket_.set(zmq::sockopt::routing_id, identity);
    socket_.set(zmq::sockopt::linger, 0);
    socket_.set(zmq::sockopt::rcvtimeo, 30000);
    if (!token.empty()) {
      const WatcherKeys keys = KeysOfWatcher(token);
      socket_.set(zmq::sockopt::curve_serverkey, keys.robot);
      socket_.set(zmq::sockopt::curve_publickey, keys.client.public_key);
      socket_.set(zmq::sockopt::curve_secretkey, keys.client.secret_key);
    }
    socket_.connect("tcp://127.0.0.1:" + std::to_string(port));
  }

  void Send(const Parts& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const bool last = i + 1 == parts.size();
      socket_.send(zmq::buffer(parts[i]), last ? zmq::send_flags::none : zmq::send_flags::sndmore);
    }
  }

  /// Empty if nothing comes in time.
  Parts Receive() {
    Parts parts;
    zmq::message_t part;
    do {
      if (!socket_.recv(part)) return {};
      parts.push_back(part.to_string());
    } while (part.more());
    return parts;
  }

  void Subscribe(const std::string& topic) { socket_.set(zmq::sockopt::subscribe, topic); }

  void set_patience(int milliseconds) { socket_.set(zmq::sockopt::rcvtimeo, milliseconds); }

 private:
  zmq::context_t context_;
  zmq::socket_t socket_;
};

/// One request, one reply.
class PlainClient {
 public:
  explicit PlainClient(std::uint16_t port) : socket_(zmq::socket_type::req, port) {}

  Parts Ask(const Parts& request) {
    socket_.Send(request);
    Parts reply = socket_.Receive();
    return reply.empty() ? Parts{"no reply in time"} : reply;
  }
  Parts Ask(char type) { return Ask({Header(type)}); }
  static std::string Header(char type) { return std::string("\x02") + type + "abcd"; }

 private:
  SocketClient socket_;
};

/// Pushes and notices that come while it waits for a reply are kept.
class ExtensionClient {
 public:
  explicit ExtensionClient(std::uint16_t port, const std::string& token = {})
      : socket_(zmq::socket_type::dealer, port, token) {}

  void Send(nlohmann::json request, const char* what) {
    request["do"] = what;
    socket_.Send({"", std::string("\x02") + "C" + "abcd", request.dump()});
  }

  nlohmann::json Ask(const char* what, nlohmann::json members = nlohmann::json::object()) {
    Send(std::move(members), what);
    for (;;) {
      const Parts parts = Receive();
      if (parts.empty()) return {{"error", "no reply in time"}};
      if (parts[1][1] == 'C') return nlohmann::json::parse(parts[2]);
    }
  }

  /// The next message: empty part, header, body. Empty if nothing comes in time.
  Parts Receive() {
    Parts parts = socket_.Receive();
    if (parts.size() == 3 && parts[1][1] == 'F') pushes.push_back(parts[2]);
    if (parts.size() == 3 && parts[1][1] == 'E') {
      notices.push_back(nlohmann::json::parse(parts[2]));
    }
    return parts;
  }

  SocketClient& socket() { return socket_; }

  std::vector<std::string> pushes;  ///< bodies
  std::vector<nlohmann::json> notices;

 private:
  SocketClient socket_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_LIVE_LIVE_CLIENT_H_
