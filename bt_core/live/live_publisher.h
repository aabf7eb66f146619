// Lets others watch a running tree: serves the requests of the Groot2 protocol for the tree, the
// state of its nodes and its blackboard.
//
//   Executor executor(program, clock);
//   LivePublisher live(executor);          // on 127.0.0.1, ports 1667 and 1668
//
// Watching cannot slow or stop the tree: the ticking thread stores one byte per change of status
// and copies blackboard values when it is asked for them; a thread of the publisher does the rest.
// Whoever reaches the port can read everything, so it listens on this computer only unless told
// otherwise; there is no request that changes the tree.
#ifndef COPPICE_BT_CORE_LIVE_LIVE_PUBLISHER_H_
#define COPPICE_BT_CORE_LIVE_LIVE_PUBLISHER_H_

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "bt_core/engine/executor.h"

namespace coppice {

struct LiveOptions {
  /// Requests; notifications leave at port + 1. Every tree needs a pair of its own: 1667, 1669, ...
  /// 0 takes a free pair; port() says which.
  std::uint16_t port = 1667;
  /// Where to listen: a local address, or "*" for every network that the computer is in.
  std::string address = "127.0.0.1";
  /// How long a BLACKBOARD request waits for a tree that is not ticking. Then it gets the values
  /// that were copied last.
  Duration patience = std::chrono::milliseconds(300);
};

class LivePublisher final : public TickSink {
 public:
  /// Between ticks, on the ticking thread; so is the destructor. The executor must live longer.
  /// Throws std::runtime_error if the ports cannot be had or the tree has more than 65535 nodes,
  /// which the protocol cannot number.
  explicit LivePublisher(Executor& executor, const LiveOptions& options = {});
  ~LivePublisher() override;
  LivePublisher(const LivePublisher&) = delete;
  LivePublisher& operator=(const LivePublisher&) = delete;

  /// Where requests are served.
  std::uint16_t port() const;

  void OnTick(const TickEvents& events) override;

 private:
  class Server;

  Executor& executor_;
  std::unique_ptr<Server> server_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_LIVE_PUBLISHER_H_
