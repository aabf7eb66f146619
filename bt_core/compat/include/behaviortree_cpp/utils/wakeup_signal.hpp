// Rouses a tree that sleeps between two ticks.
#ifndef BEHAVIORTREECORE_WAKEUP_SIGNAL_HPP
#define BEHAVIORTREECORE_WAKEUP_SIGNAL_HPP

#include <chrono>
#include <memory>
#include <utility>

#include "bt_core/data/inbox.h"

namespace BT {

/// That of a tree is the inbox of its executor.
class WakeUpSignal {
 public:
  WakeUpSignal() : WakeUpSignal(std::make_shared<coppice::Inbox>()) {}
  explicit WakeUpSignal(std::shared_ptr<coppice::Inbox> inbox) : inbox_(std::move(inbox)) {}

  /// True if there was a signal, also one that came before. The ticking thread.
  bool waitFor(std::chrono::nanoseconds duration) { return inbox_->wake_up().WaitFor(duration); }

  /// Any thread.
  void emitSignal() { inbox_->RequestTick(); }

 private:
  std::shared_ptr<coppice::Inbox> inbox_;
};

}  // namespace BT

#endif  // BEHAVIORTREECORE_WAKEUP_SIGNAL_HPP
