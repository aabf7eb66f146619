// What a debugger can do at a node, and where a tree stands. Plain values; debugger.h uses them.
#ifndef COPPICE_BT_CORE_LIVE_DEBUG_DEBUGGER_HOOKS_H_
#define COPPICE_BT_CORE_LIVE_DEBUG_DEBUGGER_HOOKS_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/status.h"
#include "bt_core/base/strong_index.h"
#include "bt_core/engine/events/event_words.h"

namespace coppice {

/// Numbers hooks; counts from 1.
using HookId = StrongIndex<struct HookTag>;
inline constexpr HookId kNoHook{0};

/// Whose hook it is: what a client owns is released when it dies.
using OwnerId = std::uint64_t;

enum class HookPosition : std::uint8_t {
  kBefore = 0,  ///< before the node is ticked, after its guards have let it
  kAfter = 1,   ///< after it was ticked
};

enum class HookAction : std::uint8_t {
  kStop = 0,     ///< the tree stands until somebody lets it go on
  kReplace = 1,  ///< `status` is the result; before the node: it is not ticked
  kDelay = 2,    ///< the node is RUNNING for `delay` and is ticked then; only before
};

/// What somebody wants to happen at a node.
struct Hook {
  /// The nodes: all that bear this path, Program::Path ("patrol/DriveTo::7"). The ID of the main
  /// tree may stand in front, and the ID of a node type without ::number means every node of the
  /// type in that instance. A path that the tree does not have waits for a tree that has it.
  std::string path;
  /// One node of the present tree, if `path` is empty. A tree that is swapped in is searched for
  /// its path.
  NodeIndex node = kNoNode;

  HookPosition position = HookPosition::kBefore;
  HookAction action = HookAction::kStop;
  Status status = Status::kSuccess;  ///< kReplace; not kIdle
  Duration delay{0};                 ///< kDelay; in the clock of the tree

  /// A script in the names of the node's place ("battery < 20"); the hook acts only when it is
  /// true. It cannot write. Empty: always.
  std::string condition;
  std::uint32_t from_hit = 1;  ///< acts from so many hits on; what the condition forbids is no hit
  std::uint32_t times = 0;     ///< acts so many times, then it is removed; 0: for ever
  bool enabled = true;
};

/// A hook that is there.
struct HookInfo {
  HookId id = kNoHook;
  OwnerId owner = 0;
  Hook hook;
  std::vector<NodeIndex> nodes;  ///< of the present tree; empty while it waits for one
  std::uint32_t hits = 0;
  std::uint32_t acted = 0;
  std::string problem;  ///< why the condition could not be computed when it was tried last
};

/// A hook that was set.
struct HookAnswer {
  HookId id = kNoHook;
  std::string remark;  ///< for people, if there is one: no such node in the present tree
};

/// Where a tree stands.
struct DebugStop {
  enum class Where : std::uint8_t {
    kNowhere,       ///< it is not stopped
    kBetweenTicks,  ///< paused, before the tick after `tick`
    kBefore,        ///< before `node`
    kAfter,         ///< after `node`, which returned `result`
  };
  Where where = Where::kNowhere;
  NodeIndex node = kNoNode;
  Status result = Status::kIdle;
  HookId hook = kNoHook;   ///< kNoHook: a pause or a step
  std::uint64_t tick = 0;  ///< the one that is going on, or the last one
};

/// Told on the ticking thread; see DebuggerOptions::on_event.
struct DebugEvent {
  enum class Kind : std::uint8_t {
    kStopped,   ///< `stop` says where; the thread blocks when the call returns
    kResumed,   ///< it goes on
    kReplaced,  ///< the hook `stop.hook` decided for `stop.node`, which is `stop.result` now
    kRefused,   ///< a stop was due, but `reason` forbids it now
  };
  Kind kind = Kind::kStopped;
  DebugStop stop;
  std::string reason;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DEBUG_DEBUGGER_HOOKS_H_
