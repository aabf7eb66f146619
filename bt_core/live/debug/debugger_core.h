// The part of a debugger that the executor knows: hooks on the ticking thread, requests from other
// threads. debugger.h is its face; it may be gone while this one still lies in the inbox.
#ifndef COPPICE_BT_CORE_LIVE_DEBUG_DEBUGGER_CORE_H_
#define COPPICE_BT_CORE_LIVE_DEBUG_DEBUGGER_CORE_H_

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/engine/node_hooks.h"
#include "bt_core/live/debug/debugger.h"
#include "bt_core/live/debug/hook_table.h"

namespace coppice {

class Debugger::Core final : public NodeHooks, public std::enable_shared_from_this<Core> {
 public:
  Core(Executor& executor, DebuggerOptions options);

  // The ticking thread.
  void BeforeTick() override;
  std::optional<Status> Before(NodeIndex node) override;
  std::optional<Status> After(NodeIndex node, Status result) override;
  void OnReload() override;

  // Any other thread; as in debugger.h.
  Expected<HookAnswer> Add(const Hook& hook, OwnerId owner);
  Expected<HookAnswer> Change(HookId id, const Hook& hook);
  bool Remove(HookId id);
  bool SetEnabled(HookId id, bool enabled);
  void RemoveAllOf(OwnerId owner);
  void SetAllEnabledOf(OwnerId owner, bool enabled);
  void Release(OwnerId owner);
  Outcome Pause(OwnerId owner);
  Outcome StepNode(OwnerId owner);
  Outcome StepTick(OwnerId owner);
  void Continue(std::optional<Status> result);
  std::vector<HookInfo> hooks() const;
  std::optional<HookInfo> Find(HookId id) const;
  DebugStop where() const;
  bool is_pausing() const;

  /// Ends everything, for good.
  void Close();
  /// Afterwards, on the ticking thread: takes the hooks from the executor.
  void Detach() { executor_.SetHooks(nullptr); }

 private:
  /// What is to happen next, if no hook stops the tree before.
  enum class Mode : std::uint8_t { kRun, kStopBeforeTick, kStopBeforeNode };
  using Lock = std::unique_lock<std::mutex>;

  // The ticking thread, with the lock.
  void HandOver();
  std::optional<Status> ActAt(Lock& lock, NodeIndex node, HookPosition position, Status result,
                              bool has_stood);
  std::optional<Status> Act(Lock& lock, HookId id, const DebugStop& stop);
  bool CountHit(HookTable::Entry& entry) const;
  std::optional<Status> ContinueDelay(HookTable::Entry& entry, NodeIndex node, bool& is_due);
  void BeginDelay(HookTable::Entry& entry, NodeIndex node);
  void RemoveIfUsedUp(HookId id);
  std::optional<Status> Stand(Lock& lock, DebugStop stop);
  void WaitForRelease(Lock& lock, bool between_ticks);
  bool IsOver() const;
  void Tell(Lock& lock, DebugEvent::Kind kind, const DebugStop& stop, std::string reason = {});

  // Any thread, with the lock.
  void ChangedHooks();
  void LeaveHook(HookId id);
  void Resume();
  Outcome Permission() const { return options_.permission ? options_.permission() : Outcome(); }
  Outcome SetMode(Mode mode, OwnerId owner);

  Executor& executor_;  // of the ticking thread
  Inbox& inbox_;        // lives as long as the executor and as the Debugger
  const DebuggerOptions options_;
  std::atomic<bool> attention_{false};  // BeforeTick has something to do

  mutable std::mutex mutex_;  // for all that follows
  std::condition_variable told_;
  HookTable table_;
  bool has_new_hooks_ = false;
  bool stops_at_all_nodes_ = false;  // they are all chosen, for a step
  Mode mode_ = Mode::kRun;
  OwnerId controller_ = 0;  // who has set the mode
  DebugStop stop_;
  bool resumes_ = false;
  std::optional<Status> forced_;
  bool is_telling_ = false;
  bool is_closed_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DEBUG_DEBUGGER_CORE_H_
