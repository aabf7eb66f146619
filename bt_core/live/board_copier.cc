#include "bt_core/live/board_copier.h"

#include <condition_variable>
#include <mutex>
#include <utility>

namespace coppice {

struct BoardCopier::Exchange {
  std::mutex mutex;
  std::condition_variable answered;
  bool asked = false;  // a call lies in the inbox
  bool cancelled = false;
  std::vector<std::pair<SlotIndex, Value>> answer;
};

BoardCopier::BoardCopier(Executor& executor)
    : executor_(executor), exchange_(std::make_shared<Exchange>()) {
  for (const Slot& slot : executor.blackboard()) values_.push_back(slot.value);
}

BoardCopier::~BoardCopier() { Cancel(); }

void BoardCopier::Ask(const std::vector<ScopeIndex>& scopes) {
  std::vector<SlotIndex> wanted;
  const std::vector<SlotDefinition>& slots = executor_.program().layout.slots;
  for (const ScopeIndex scope : scopes) {
    for (SlotIndex slot = 0; slot < slots.size(); ++slot) {
      if (slots[slot].scope == scope && !slots[slot].key.empty()) wanted.push_back(slot);
    }
  }
  executor_.inbox()->PostCall(
      [exchange = exchange_, wanted = std::move(wanted), &executor = std::as_const(executor_)] {
        std::vector<std::pair<SlotIndex, Value>> answer;
        answer.reserve(wanted.size());
        for (const SlotIndex slot : wanted) {
          answer.emplace_back(slot, executor.blackboard()[slot].value);
        }
        const std::lock_guard<std::mutex> lock(exchange->mutex);
        exchange->answer = std::move(answer);
        exchange->asked = false;
        exchange->answered.notify_all();
      });
}

const std::vector<Value>& BoardCopier::Copy(const std::vector<ScopeIndex>& scopes,
                                            Duration patience) {
  std::unique_lock<std::mutex> lock(exchange_->mutex);
  Take();  // an answer that came too late for the request before
  if (exchange_->asked || exchange_->cancelled) return values_;
  exchange_->asked = true;
  lock.unlock();
  Ask(scopes);
  lock.lock();
  exchange_->answered.wait_for(lock, patience,
                               [this] { return !exchange_->asked || exchange_->cancelled; });
  Take();
  return values_;
}

void BoardCopier::Take() {
  for (auto& [slot, value] : exchange_->answer) values_[slot] = std::move(value);
  exchange_->answer.clear();
}

void BoardCopier::Cancel() {
  const std::lock_guard<std::mutex> lock(exchange_->mutex);
  exchange_->cancelled = true;
  exchange_->answered.notify_all();
}

}  // namespace coppice
