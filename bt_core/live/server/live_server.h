// The endpoint of live views: two ports, any number of trees, any number of clients.
//
//   LiveServer server;
//   LivePublisher patrol(patrol_stream, server);
//   LivePublisher docking(docking_stream, server);
//
// For a single tree LivePublisher makes its own. docs/live.md is the manual, and the reference for
// those who write clients.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_LIVE_SERVER_H_
#define COPPICE_BT_CORE_LIVE_SERVER_LIVE_SERVER_H_

#include <cstdint>
#include <memory>
#include <string>

#include "bt_core/live/server/live_options.h"

namespace coppice {

class LiveTree;

/// Where browsers find a live view.
struct LiveWeb {
  std::uint16_t port = 0;  ///< 0: nowhere
  /// Parts of the address that a browser needs, if there is a token; else empty.
  std::string control_token;
  std::string read_token;
};

class LiveServer {
 public:
  /// Listens when it returns. Throws std::runtime_error, with a text for people, if the ports
  /// cannot be had, and std::invalid_argument if the address needs a token or the token is none.
  explicit LiveServer(const LiveOptions& options = {});
  /// Trees must have been taken off.
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  /// Where requests are served.
  std::uint16_t port() const;

  /// For people who may only watch; empty if there is no token.
  const std::string& read_token() const;

  /// The web side, with LiveOptions::web.
  const LiveWeb& web() const;

  /// Called by LivePublisher.
  void Add(std::shared_ptr<LiveTree> tree);
  /// Returns when clients were sent what has happened and no thread of the server uses the tree.
  void Remove(const std::shared_ptr<LiveTree>& tree);
  /// Any thread: there is something to send.
  void Wake();

 private:
  class Loop;

  std::unique_ptr<Loop> loop_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_LIVE_SERVER_H_
