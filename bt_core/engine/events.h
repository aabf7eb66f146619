// What happened in a tick, for those who watch: live view, recorder, statistics.
#ifndef COPPICE_BT_CORE_ENGINE_EVENTS_H_
#define COPPICE_BT_CORE_ENGINE_EVENTS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/status.h"
#include "bt_core/data/blackboard.h"
#include "bt_core/nodes/control.h"

namespace coppice {

struct StatusChange {
  NodeIndex node;
  Status from;
  Status to;
};

/// Why a node did what it did: a leaf's reason for failing, the text of an exception.
struct NodeMessage {
  NodeIndex node;
  std::string text;
};

/// One tick, or one halt of the whole tree. References are valid during the call only.
struct TickEvents {
  std::uint64_t tick;  ///< counts from 1; a halt bears the number of the tick before it
  Time start;          ///< in the tree's clock
  Status result;       ///< of the root; kIdle for a halt
  const std::vector<StatusChange>& changes;  ///< in the order of happening
  const std::vector<SlotIndex>&
      writes;  ///< slots that were written in or before this tick, each once
  const std::vector<NodeMessage>& messages;
  const Blackboard& blackboard;  ///< as it is after the tick
};

class Executor;

/// Gets every tick. Called on the ticking thread, so it must neither block nor throw: copy and
/// return.
class TickSink {
 public:
  virtual ~TickSink() = default;
  virtual void OnTick(const TickEvents& events) = 0;

  /// The executor goes on with another program (Executor::Reload): numbers of nodes and slots have
  /// a new meaning. Only a sink that says that it can follow is told.
  virtual bool can_follow_reload() const { return false; }
  virtual void OnReload(const Executor&) {}
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EVENTS_H_
