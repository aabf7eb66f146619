// Stops a running tree from another thread, walks it node by node, and forces results: breakpoints,
// pause and step, injected faults.
//
//   Debugger debugger(executor);                          // ticking thread, between ticks
//   ...
//   Hook hook;                                            // any thread
//   hook.path = "dock/ReadBattery::9";
//   hook.condition = "battery < 20";
//   const Expected<HookAnswer> answer = debugger.Add(hook, owner);
//   if (!answer) std::cerr << answer.problem();
//   ...
//   debugger.Continue();
//
// A stop blocks the ticking thread; before, the watchers get what the tick has done so far. The
// tree's clock goes on meanwhile. Hooks are handed to the ticking thread between two ticks; what
// releases a tree acts at once. While nothing is set, a tick costs one call and one load.
#ifndef COPPICE_BT_CORE_LIVE_DEBUG_DEBUGGER_H_
#define COPPICE_BT_CORE_LIVE_DEBUG_DEBUGGER_H_

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "bt_core/engine/executor.h"
#include "bt_core/live/debug/debugger_hooks.h"

namespace coppice {

struct DebuggerOptions {
  /// Whether the tree may be stopped and changed now, or why not ("the robot moves"). Asked by
  /// every request that does so, on the thread of the caller, and once more by the ticking thread
  /// before a stop. Null: always allowed. Must not call the debugger.
  std::function<Outcome()> permission;

  /// Called on the ticking thread; must be quick, must not throw, may only read from the debugger.
  std::function<void(const DebugEvent&)> on_event;
};

/// All functions may be called on any thread but the ticking one, unless they say otherwise; on the
/// ticking thread only between ticks.
class Debugger {
 public:
  /// Ticking thread, between ticks. At most one debugger per executor at a time.
  explicit Debugger(Executor& executor, DebuggerOptions options = {});
  /// Lets the tree go on without hooks. Waits until the ticking thread is out of `on_event`. The
  /// executor may be gone already.
  ~Debugger();
  Debugger(const Debugger&) = delete;
  Debugger& operator=(const Debugger&) = delete;

  Expected<HookAnswer> Add(const Hook& hook, OwnerId owner = 0);
  /// Becomes another hook and counts its hits anew; a tree that stands at it goes on.
  Expected<HookAnswer> Change(HookId id, const Hook& hook);
  /// False if there is no such hook. A tree that stands at it goes on; so it does below.
  bool Remove(HookId id);
  bool SetEnabled(HookId id, bool enabled);

  /// The same for all hooks of an owner.
  void RemoveAllOf(OwnerId owner);
  void SetAllEnabledOf(OwnerId owner, bool enabled);
  /// A client is gone: its hooks are removed, and a tree that it has paused or stepped goes on.
  void Release(OwnerId owner);
  /// For the end of a program: everything goes on, and nothing is ever stopped again.
  void ReleaseAll();

  /// Stops before the next tick.
  Outcome Pause(OwnerId owner = 0);
  /// To the next node that is about to be ticked, or to the end of the tick. A tree that is not
  /// stopped stops there too.
  Outcome StepNode(OwnerId owner = 0);
  /// To the end of the tick; between ticks: one whole tick.
  Outcome StepTick(OwnerId owner = 0);
  /// Goes on until the next breakpoint. With a status (not kIdle), the tree goes on as if the node
  /// that it stands at had returned that.
  void Continue(std::optional<Status> result = std::nullopt);

  std::vector<HookInfo> hooks() const;
  std::optional<HookInfo> Find(HookId id) const;
  DebugStop where() const;
  /// Stopped, or about to stop before the next tick.
  bool is_pausing() const;

 private:
  class Core;

  std::shared_ptr<Core> core_;    // also held by the call that lies in the inbox at the end
  std::shared_ptr<Inbox> inbox_;  // of the executor
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DEBUG_DEBUGGER_H_
