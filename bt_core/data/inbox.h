// The only way into a running tree from other threads.
//
// Sensor callbacks, workers and remote clients post here; the ticking thread applies everything at
// the start of a tick, so during a tick the world stands still and all leaves see the same of it.
// Posting wakes a sleeping tree.
//
//   Sender<double> battery = executor.Writer<double>("battery_level");   // once, at wiring time
//   battery.Send(0.71);                                                  // from any thread
#ifndef COPPICE_BT_CORE_DATA_INBOX_H_
#define COPPICE_BT_CORE_DATA_INBOX_H_

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "bt_core/base/strong_index.h"
#include "bt_core/base/wake_up.h"
#include "bt_core/data/value.h"

namespace coppice {

using SlotIndex = StrongIndex<struct SlotTag>;
inline constexpr SlotIndex kNoSlot{UINT32_MAX};

class Inbox {
 public:
  struct Message {
    SlotIndex slot;
    std::uint32_t epoch;       ///< for mailboxes: the activation of the leaf that asked for it
    std::uint32_t generation;  ///< of the tree whose slot it is
    Value value;
  };
  using Call = std::function<void()>;

  /// Any thread. The value replaces what the slot holds at the start of the next tick. A slot of an
  /// earlier generation is that slot under its present number.
  void Post(SlotIndex slot, std::uint32_t epoch, Value value, std::uint32_t generation);
  void Post(SlotIndex slot, std::uint32_t epoch, Value value) {
    Post(slot, epoch, std::move(value), generation());
  }

  /// Counts the trees that were swapped in: slots are numbered anew by each.
  std::uint32_t generation() const { return generation_.load(std::memory_order_relaxed); }

  /// Ticking thread: begins a generation. `new_numbers`: for each slot of the last one its number
  /// now, or kNoSlot; then what is sent to it is dropped.
  void Renumber(const std::vector<SlotIndex>& new_numbers);

  /// Any thread. The function runs on the ticking thread, between two ticks.
  void PostCall(Call call);

  /// Any thread. The tree is ticked soon although nothing was written: see Pace::kEvents.
  void RequestTick();

  /// Any thread, also a signal handler: whoever ticks the tree wants to end soon, or begins anew.
  /// Who blocks the ticking thread on purpose must let it go then.
  void set_ending(bool ending) {
    is_ending_.store(ending, std::memory_order_relaxed);
    wake_up_.Notify();
  }
  bool is_ending() const { return is_ending_.load(std::memory_order_relaxed); }

  /// Ticking thread: true if there is something to take. Costs one relaxed load.
  bool has_messages() const { return has_messages_.load(std::memory_order_relaxed); }
  bool has_calls() const { return has_calls_.load(std::memory_order_relaxed); }

  /// Ticking thread: everything that was posted so far, in order; replaces the content of the
  /// argument.
  void TakeMessages(std::vector<Message>& out);
  void TakeCalls(std::vector<Call>& out);

  /// True if there was a request since the last call.
  bool TakeTickRequest() {
    return tick_requested_.load(std::memory_order_relaxed) &&
           tick_requested_.exchange(false, std::memory_order_relaxed);
  }

  /// Notified at every post.
  WakeUp& wake_up() { return wake_up_; }

 private:
  SlotIndex Find(const Message& message) const;

  std::mutex mutex_;
  std::vector<Message> messages_;
  std::vector<std::vector<SlotIndex>> renumbered_;  // per earlier generation: the numbers now
  std::vector<Call> calls_;
  std::atomic<bool> has_messages_{false};
  std::atomic<bool> has_calls_{false};
  std::atomic<bool> tick_requested_{false};
  std::atomic<bool> is_ending_{false};
  std::atomic<std::uint32_t> generation_{0};
  WakeUp wake_up_;
};

/// Writes one slot through the inbox. A value: copy it freely, use it from any thread, also after
/// the tree is gone. A default-made Sender drops what is sent.
template <class T>
class Sender {
 public:
  Sender() = default;
  Sender(std::shared_ptr<Inbox> inbox, SlotIndex slot, std::uint32_t epoch)
      : inbox_(std::move(inbox)),
        slot_(slot),
        epoch_(epoch),
        generation_(inbox_ ? inbox_->generation() : 0) {}

  void Send(const T& value) const {
    if (inbox_) inbox_->Post(slot_, epoch_, Value(value), generation_);
  }
  explicit operator bool() const { return inbox_ != nullptr; }

 private:
  std::shared_ptr<Inbox> inbox_;
  SlotIndex slot_ = kNoSlot;
  std::uint32_t epoch_ = 0;
  std::uint32_t generation_ = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_DATA_INBOX_H_
