// A running tree as Python has it: the program, its executor and who watches it, with rules for
// threads that no mistake in Python can break.
//
// One thread at a time ticks: who comes second gets an error. Keys are written from any thread
// through the inbox; they are read between two ticks: by the ticking thread itself, by anybody
// while nobody ticks, and else by a call that the ticking thread carries out.
//
// Functions are called with the GIL unless they say otherwise; they let go of it while C++ works.
#ifndef COPPICE_BT_CORE_PYTHON_TREE_H_
#define COPPICE_BT_CORE_PYTHON_TREE_H_

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "bt_core/engine/events/event_stream.h"
#include "bt_core/engine/runner.h"
#include "bt_core/python/leaf.h"

namespace coppice::python {

class Tree {
 public:
  /// Makes the leaves, so it throws what their __init__ raises.
  static std::shared_ptr<Tree> Make(std::shared_ptr<const Program> program,
                                    std::shared_ptr<Clock> clock, ExceptionPolicy on_exception);
  /// For Make, which also sees to the end.
  Tree(std::shared_ptr<const Program> program, std::shared_ptr<Clock> clock,
       ExceptionPolicy on_exception);
  ~Tree();  // stops and halts
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  const Program& program() const { return *program_; }
  std::shared_ptr<const Program> shared_program() const { return program_; }
  Clock& clock() { return *clock_; }

  Status Tick();
  /// Of the calling thread. Ctrl+C on the main thread stops it and raises KeyboardInterrupt.
  Status Run(const RunOptions& options);
  void Halt();
  /// Any thread: asks Run to end; waits for it if it is on another thread.
  void Stop();
  bool is_running() const;

  std::vector<Status> Statuses();
  Status RootStatus();
  std::uint64_t Ticks();
  double NextTick();

  /// Throws KeyError with the nearest right name.
  SlotIndex Find(const std::string& key) const;
  std::vector<std::string> Keys() const;
  py::object Get(SlotIndex slot);
  bool IsSet(SlotIndex slot);
  /// Counts at once if nobody ticks, else in the next tick.
  void Set(const std::string& key, py::handle value);
  void RequestTick() { executor_->inbox()->RequestTick(); }

  /// For who watches it; made when it is asked for the first time. With Use only.
  EventStream& stream();

  /// Runs the function between two ticks, no matter who ticks, and throws what it throws. It must
  /// not need the GIL.
  void Use(const std::function<void(Executor&)>& function);

  /// The same for what may not be done within a tick: throws if a leaf of this tree asks for it.
  void UseBetweenTicks(const std::function<void(Executor&)>& function);

  /// Without the GIL: stops and halts it, if it can be had until then.
  void End(std::chrono::steady_clock::time_point deadline);

 private:
  class Ticking;
  struct Request;
  bool IsMine() const { return ticker_.load() == std::this_thread::get_id(); }
  bool TryEnter();
  void Enter();
  void Leave();
  void AskWhoTicks(const std::shared_ptr<Request>& request);
  void RaiseError(const std::exception_ptr& error, const Interruption& interruption);

  const std::shared_ptr<const Program> program_;
  const std::shared_ptr<Clock> clock_;
  std::unique_ptr<Executor> executor_;
  std::optional<EventStream> stream_;

  mutable std::mutex mutex_;  // of the next two
  std::condition_variable changed_;
  Runner* runner_ = nullptr;
  std::atomic<std::thread::id> ticker_{};  // nobody: nobody ticks
};

/// At the end of the program, as long as Python can still run: stops and halts all trees, and lets
/// none begin again. Waits for threads that tick, at most ten seconds.
void EndAllTrees();

}  // namespace coppice::python

#endif  // COPPICE_BT_CORE_PYTHON_TREE_H_
