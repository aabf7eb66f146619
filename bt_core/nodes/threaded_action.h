// An action whose work takes long and blocks: it runs on a thread of its own, the tree goes on.
//
//   class PlanPath : public ThreadedAction {
//    public:
//     static constexpr const char* kDescription = "Plans a path.";
//     Input<Pose2D> goal{this, "goal", "where to, in map [m, m, rad]"};
//     Output<Path> path{this, "path", "the way"};
//
//    private:
//     void Prepare() override { goal_ = *goal; }            // ticking thread
//     Status Work(const StopToken& stop) override {         // own thread: no ports here
//       path_ = planner_.Plan(goal_, [&] { return stop.stop_requested(); });
//       return path_.empty() ? Status::kFailure : Status::kSuccess;
//     }
//     void Finish() override { path.Set(path_); }           // ticking thread
//     Pose2D goal_;
//     Path path_;
//   };
//
// The three functions never run at the same time, so they share members without a lock. The result
// arrives as a message that wakes the tree. Halting requests the stop and returns at once; while
// Work has not returned the node drains, and a new activation waits for it.
#ifndef COPPICE_BT_CORE_NODES_THREADED_ACTION_H_
#define COPPICE_BT_CORE_NODES_THREADED_ACTION_H_

#include <atomic>
#include <memory>
#include <string>

#include "bt_core/base/stop_token.h"
#include "bt_core/nodes/leaf.h"

namespace coppice {

/// How Work ended.
struct WorkResult {
  Status status = Status::kFailure;
  std::string message;  ///< why it failed, if it threw
};

template <>
struct ValueTraits<WorkResult> {
  static constexpr const char* kName = "WorkResult";
  static bool Parse(std::string_view, WorkResult&) { return false; }
  static std::string Print(const WorkResult& result) { return ToString(result.status); }
};

class ThreadedAction : public Action {
 public:
  ThreadedAction();
  ~ThreadedAction() override;

  /// Requests the stop and waits until Work has returned. Who registers the class need not care:
  /// the registry's nodes do it before anything of them is destroyed. Who makes one by hand calls
  /// it before the end of its life.
  void BeforeDestruction();

  Status OnStart() final;
  Status OnRunning() final;
  void OnHalted() final;
  bool OnDraining() final { return !is_working(); }

 protected:
  /// Ticking thread, at the start of an activation: copy here what Work needs.
  virtual void Prepare() {}

  /// Own thread. Returns SUCCESS, FAILURE or SKIPPED, and soon after the stop was requested. Must
  /// not touch ports, Say, now() or the blackboard. If it throws, the action fails with that text.
  virtual Status Work(const StopToken& stop) = 0;

  /// Ticking thread, in the tick that takes the result: write outputs here. Not called after a
  /// halt, nor if Work threw.
  virtual void Finish() {}

  /// For how long a halted node may go on working before the engine calls it a fault.
  virtual Duration stop_limit() const { return std::chrono::seconds(5); }

  /// As debuggers and `top -H` show it, at most 15 characters.
  virtual const char* thread_name() const { return "coppice-work"; }

 private:
  class Worker;
  bool is_working() const { return working_.load(std::memory_order_acquire); }
  Status Begin();
  void WorkOnce();  // own thread

  Mailbox<WorkResult> result_{this, "result"};
  Sender<WorkResult> sender_;
  StopToken stop_;
  std::atomic<bool> working_{false};
  bool begun_ = false;              // this activation has handed its work over
  std::unique_ptr<Worker> worker_;  // made in the first activation
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_THREADED_ACTION_H_
