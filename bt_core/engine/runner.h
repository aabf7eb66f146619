// The loop that keeps a tree ticking.
//
//   Runner runner(executor, {Pace::kEvents, kForever});   // tick when something happens
//   std::thread thread([&] { result = runner.Run(); });
//   ...
//   runner.Stop();                                       // the tree is halted when this returns
//   thread.join();
//
// For a single tick there is Executor::Tick().
#ifndef COPPICE_BT_CORE_ENGINE_RUNNER_H_
#define COPPICE_BT_CORE_ENGINE_RUNNER_H_

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

#include "bt_core/engine/executor.h"

namespace coppice {

enum class Pace : std::uint8_t {
  /// A tick when a message arrives, when somebody calls Inbox::RequestTick, when a timer of the
  /// tree is due or a node asks for the next tick at once; in between the thread sleeps.
  kEvents,
  /// A tick at every multiple of the period after the first tick, and at no other time. Where a
  /// tick takes longer than a period, the periods that it misses are left out.
  kFixedRate,
};

struct RunOptions {
  Pace pace = Pace::kEvents;
  /// kFixedRate: from tick to tick; must be positive. kEvents: a tick at least this often, for
  /// leaves that poll; kForever: on events only.
  Duration period = std::chrono::milliseconds(100);
  /// Start again when the root has completed, as an arbiter does that runs for ever.
  bool forever = false;
  /// An event that follows another within this time finds the thread awake, at the cost of the
  /// processor (WakeUp::set_lookout): the tick begins some microseconds earlier. Not on a computer
  /// with one processor. 0: the thread always sleeps.
  Duration lookout = std::chrono::microseconds(50);
};

class Runner {
 public:
  /// The executor must outlive the runner. Throws std::invalid_argument if the period of kFixedRate
  /// is not a positive time.
  Runner(Executor& executor, RunOptions options = {});
  ~Runner();  // stops
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Ticks on the calling thread until the root completes or someone stops it, then halts the tree
  /// and waits for leaves that need time to stop (Action::OnDraining). Returns the last result of
  /// the root; kIdle if it was stopped before the first tick. May be called once.
  Status Run();

  /// Asks Run to end after the tick that is going on. Returns at once. Any thread, also a signal
  /// handler. Before Run: Run ends without a tick.
  void RequestStop();

  /// RequestStop, and waits until the tree has been halted and every leaf has stopped. Any thread;
  /// in the ticking thread (a leaf, a sink) it cannot wait and returns at once.
  void Stop();

  bool stop_requested() const { return stop_.load(std::memory_order_relaxed); }

  /// kFixedRate: ticks that ended after the next one should have begun, and periods left out
  /// because of them. Any thread.
  std::uint64_t overruns() const { return overruns_.load(std::memory_order_relaxed); }
  std::uint64_t missed_periods() const { return missed_periods_.load(std::memory_order_relaxed); }

 private:
  Status TickUntilDone();
  void HaltTree();
  Time NextTick();
  Time NextPeriod();
  bool HasEvent();
  void Wait(Time next);

  Executor& executor_;
  const RunOptions options_;
  Time scheduled_{};  // kFixedRate: when the tick that is going on should have begun
  std::atomic<bool> stop_{false};
  std::atomic<std::uint64_t> overruns_{0};
  std::atomic<std::uint64_t> missed_periods_{0};

  std::mutex mutex_;
  std::condition_variable ended_;
  std::thread::id running_on_;  // of no thread: not running
};

/// Ticks until the root completes; then halts the tree and returns the root's result.
Status Run(Executor& executor, const RunOptions& options = {});

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_RUNNER_H_
