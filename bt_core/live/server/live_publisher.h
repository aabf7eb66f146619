// Lets others watch and debug a running tree: coppice live, the editor, Groot2, scripts.
//
//   EventStream stream(executor);
//   LivePublisher live(stream);                  // 127.0.0.1, ports 1667 and 1668
//
// The ticking thread does nothing for it but what the stream does anyway; nothing that a client
// does or fails to do is felt by the tree, unless it may control the tree and stops it.
// docs/live.md is the manual.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_LIVE_PUBLISHER_H_
#define COPPICE_BT_CORE_LIVE_SERVER_LIVE_PUBLISHER_H_

#include <cstdint>
#include <memory>

#include "bt_core/engine/events/event_stream.h"
#include "bt_core/live/server/live_options.h"
#include "bt_core/live/server/live_server.h"

namespace coppice {

class Debugger;
class LiveTree;

class LivePublisher {
 public:
  /// With an endpoint of its own. Between ticks, on the ticking thread; so is the destructor. The
  /// stream must live longer. Throws as LiveServer does.
  explicit LivePublisher(EventStream& stream, const LiveOptions& options = {});
  /// One of several trees at an endpoint, which must live longer.
  LivePublisher(EventStream& stream, LiveServer& server, const LiveTreeOptions& options = {});
  ~LivePublisher();
  LivePublisher(const LivePublisher&) = delete;
  LivePublisher& operator=(const LivePublisher&) = delete;

  /// Where requests are served.
  std::uint16_t port() const { return server_.port(); }
  /// For people who may only watch; empty if there is no token.
  const std::string& read_token() const { return server_.read_token(); }
  /// Where browsers find it, with LiveOptions::web.
  const LiveWeb& web() const { return server_.web(); }

  /// What the clients use to stop the tree. A program that wants its ticking thread back, to end
  /// itself, calls Debugger::ReleaseAll.
  Debugger& debugger();

 private:
  LivePublisher(EventStream& stream, std::unique_ptr<LiveServer> own, LiveServer* other,
                const LiveTreeOptions& options);

  std::unique_ptr<LiveServer> own_server_;
  LiveServer& server_;
  EventStream& stream_;
  std::shared_ptr<LiveTree> tree_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_LIVE_PUBLISHER_H_
