#include "bt_core/engine/runner.h"

#include <algorithm>
#include <stdexcept>

namespace coppice {

Runner::Runner(Executor& executor, RunOptions options) : executor_(executor), options_(options) {
  if (options_.pace == Pace::kFixedRate &&
      (options_.period <= Duration::zero() || options_.period == kForever)) {
    throw std::invalid_argument("a fixed rate needs a positive period");
  }
  executor_.inbox()->set_ending(false);
  if (std::thread::hardware_concurrency() > 1) executor_.wake_up().set_lookout(options_.lookout);
}

Runner::~Runner() { Stop(); }

Status Runner::Run() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    running_on_ = std::this_thread::get_id();
  }
  const Status result = TickUntilDone();
  HaltTree();
  // Under the lock to the end: who waits in Stop may destroy the runner as soon as it is free.
  const std::lock_guard<std::mutex> lock(mutex_);
  running_on_ = {};
  ended_.notify_all();
  return result;
}

void Runner::RequestStop() {
  stop_.store(true, std::memory_order_relaxed);
  executor_.inbox()->set_ending(true);  // also wakes the thread, which sees both
}

void Runner::Stop() {
  RequestStop();
  std::unique_lock<std::mutex> lock(mutex_);
  if (running_on_ == std::this_thread::get_id()) return;
  ended_.wait(lock, [this] { return running_on_ == std::thread::id(); });
}

Status Runner::TickUntilDone() {
  Status result = Status::kIdle;
  scheduled_ = executor_.clock().Now();
  while (!stop_requested()) {
    executor_.inbox()->TakeTickRequest();  // this is the tick that was requested
    result = executor_.Tick();
    if (result != Status::kRunning && !options_.forever) break;
    Wait(NextTick());
  }
  return result;
}

// Returns when every leaf has stopped or has been given up.
void Runner::HaltTree() {
  executor_.Halt();
  while (executor_.is_draining()) {
    executor_.ServeDrains();
    if (!executor_.is_draining()) break;
    executor_.clock().WaitUntil(executor_.next_tick(), executor_.wake_up());
    executor_.RunCalls();
  }
}

Time Runner::NextTick() {
  if (options_.pace == Pace::kFixedRate) return NextPeriod();
  if (options_.period == kForever) return executor_.next_tick();
  return std::min(executor_.next_tick(), executor_.now() + options_.period);
}

Time Runner::NextPeriod() {
  scheduled_ += options_.period;
  const Duration late = executor_.clock().Now() - scheduled_;
  if (late > Duration::zero()) {
    const auto missed = (late + options_.period - Duration(1)) / options_.period;
    scheduled_ += missed * options_.period;
    ++overruns_;
    missed_periods_ += static_cast<std::uint64_t>(missed);
  }
  return scheduled_;
}

bool Runner::HasEvent() {
  return options_.pace == Pace::kEvents &&
         (executor_.inbox()->has_messages() || executor_.inbox()->TakeTickRequest());
}

// Calls of remote clients are served without a tick.
void Runner::Wait(Time next) {
  while (!stop_requested() && !HasEvent() && executor_.clock().Now() < next) {
    executor_.clock().WaitUntil(next, executor_.wake_up());
    executor_.RunCalls();
  }
}

Status Run(Executor& executor, const RunOptions& options) {
  return Runner(executor, options).Run();
}

}  // namespace coppice
