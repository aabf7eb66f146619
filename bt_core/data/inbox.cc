#include "bt_core/data/inbox.h"

namespace coppice {

void Inbox::Post(SlotIndex slot, std::uint32_t epoch, Value value) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages_.push_back({slot, epoch, std::move(value)});
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
}

void Inbox::TakeCalls(std::vector<Call>& out) {
  out.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  out.swap(calls_);
  has_calls_.store(false, std::memory_order_relaxed);
}

}  // namespace coppice
