// What happened in a tick, for those who watch on the ticking thread. Who can wait a millisecond
// watches from another thread: event_stream.h.
#ifndef COPPICE_BT_CORE_ENGINE_EVENTS_H_
#define COPPICE_BT_CORE_ENGINE_EVENTS_H_

#include <cstdint>

#include "bt_core/base/clock.h"
#include "bt_core/base/status.h"
#include "bt_core/engine/events/event_words.h"

namespace coppice {

/// One tick, one halt of the whole tree, or what happened between two ticks. The words are valid
/// during the call only.
struct TickEvents {
  std::uint64_t tick;  ///< counts from 1; what is no tick bears the number of the tick before it
  Time start;          ///< in the tree's clock
  Duration duration;   ///< that the tick took, in real time; 0 for what is no tick
  Status result;       ///< of the root; kIdle if this is no tick
  bool is_whole;       ///< false: the tree stands at a breakpoint, the rest of the tick follows
  EventWords words;
};

class Executor;

/// Gets every tick. Called on the ticking thread, so it must neither block nor throw: copy and
/// return.
class TickSink {
 public:
  virtual ~TickSink() = default;
  virtual void OnTick(const TickEvents& events) = 0;

  /// The tree has another program (Executor::Reload) or another state (Executor::Restore): what is
  /// known of its nodes and slots no longer holds. Between ticks.
  virtual void OnJump(const Executor&) {}
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EVENTS_H_
