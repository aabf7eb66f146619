#include "bt_core/data/inbox.h"

#include <algorithm>

namespace coppice {

void Inbox::Post(SlotIndex slot, std::uint32_t epoch, Value value, std::uint32_t generation) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages_.push_back({slot, epoch, generation, std::move(value)});
    has_messages_.store(true, std::memory_order_relaxed);
  }
  wake_up_.Notify();
}

void Inbox::PostCall(Call call) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    calls_.push_back(std::move(call));
    has_calls_.store(true, std::memory_order_relaxed);
  }
  wake_up_.Notify();
}

void Inbox::RequestTick() {
  tick_requested_.store(true, std::memory_order_relaxed);
  wake_up_.Notify();
}

void Inbox::TakeMessages(std::vector<Message>& out) {
  out.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  out.swap(messages_);
  has_messages_.store(false, std::memory_order_relaxed);
  if (renumbered_.empty()) return;
  for (Message& message : out) message.slot = Find(message);
  const auto is_lost = [](const Message& message) { return message.slot == kNoSlot; };
  out.erase(std::remove_if(out.begin(), out.end(), is_lost), out.end());
}

SlotIndex Inbox::Find(const Message& message) const {
  if (message.generation >= renumbered_.size()) return message.slot;
  return renumbered_[message.generation][message.slot];
}

void Inbox::Renumber(const std::vector<SlotIndex>& new_numbers) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::vector<SlotIndex>& numbers : renumbered_) {
    for (SlotIndex& number : numbers) {
      if (number != kNoSlot) number = new_numbers[number];
    }
  }
  renumbered_.push_back(new_numbers);
  generation_.fetch_add(1, std::memory_order_relaxed);
}

void Inbox::TakeCalls(std::vector<Call>& out) {
  out.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  out.swap(calls_);
  has_calls_.store(false, std::memory_order_relaxed);
}

}  // namespace coppice
