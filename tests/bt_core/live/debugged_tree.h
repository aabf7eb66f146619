// A tree of scripted leaves with a debugger, ticked by a thread of its own, and what the debugger
// has told.
#ifndef COPPICE_TESTS_BT_CORE_LIVE_DEBUGGED_TREE_H_
#define COPPICE_TESTS_BT_CORE_LIVE_DEBUGGED_TREE_H_

#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/live/debug/debugger.h"
#include "tests/bt_core/engine/fixture.h"

namespace coppice {

class DebuggedTree {
 public:
  using Kind = DebugEvent::Kind;
  using Where = DebugStop::Where;

  explicit DebuggedTree(const std::string& text, LeafScript script = {})
      : stage(text, std::move(script)) {
    DebuggerOptions options;
    options.on_event = [this](const DebugEvent& event) { Keep(event); };
    options.permission = [this] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return permission_;
    };
    debugger = std::make_unique<Debugger>(*stage.executor, options);
  }
  ~DebuggedTree() { debugger.reset(); }

  /// On another thread.
  std::future<Status> Tick(int times = 1) {
    return std::async(std::launch::async, [this, times] {
      Status result = Status::kIdle;
      for (int i = 0; i < times; ++i) result = stage.executor->Tick();
      return result;
    });
  }

  /// The next thing that the debugger tells; a resumption of nowhere if nothing comes.
  DebugEvent Next() {
    std::unique_lock<std::mutex> lock(mutex_);
    const bool came =
        came_.wait_for(lock, std::chrono::seconds(30), [&] { return !told_.empty(); });
    if (!came) return {Kind::kResumed, {}, "nothing was told within 30 s"};
    DebugEvent event = told_.front();
    told_.pop_front();
    return event;
  }
  /// "before 2", "after 2 SUCCESS", "between 1", "resumed", "replaced 2 FAILURE", "refused WHY".
  std::string NextText() { return Describe(Next()); }
  std::size_t told() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return told_.size();
  }

  void Refuse(std::string why) {
    const std::lock_guard<std::mutex> lock(mutex_);
    permission_ = Problem{std::move(why)};
  }

  HookId Set(NodeIndex node, HookPosition position = HookPosition::kBefore) {
    Hook hook;
    hook.node = node;
    hook.position = position;
    return debugger->Add(hook)->id;
  }

  Stage stage;
  std::unique_ptr<Debugger> debugger;

 private:
  void Keep(const DebugEvent& event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    told_.push_back(event);
    came_.notify_all();
  }

  static std::string Describe(const DebugEvent& event) {
    const DebugStop& stop = event.stop;
    const std::string node = std::to_string(stop.node);
    switch (event.kind) {
      case Kind::kResumed:
        return "resumed" + event.reason;
      case Kind::kRefused:
        return "refused " + event.reason;
      case Kind::kReplaced:
        return "replaced " + node + " " + ToString(stop.result);
      default:
        break;
    }
    if (stop.where == Where::kBefore) return "before " + node;
    if (stop.where == Where::kAfter) return "after " + node + " " + ToString(stop.result);
    return "between " + std::to_string(stop.tick);
  }

  std::mutex mutex_;
  std::condition_variable came_;
  std::deque<DebugEvent> told_;
  Outcome permission_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_LIVE_DEBUGGED_TREE_H_
