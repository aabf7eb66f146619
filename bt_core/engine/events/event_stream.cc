#include "bt_core/engine/events/event_stream.h"

#include <utility>

#include "bt_core/data/value_bytes.h"
#include "bt_core/engine/events/event_worker.h"

namespace coppice {

EventStream::EventStream(Executor& executor, std::size_t ring_bytes)
    : executor_(executor),
      worker_(std::make_unique<EventWorker>(ring_bytes / sizeof(std::uint32_t))) {}

EventStream::~EventStream() {
  if (listeners_ > 0) executor_.RemoveSink(this);
}

void EventStream::Add(EventListener& listener) {
  worker_->Add(listener, StateNow(StreamState::Cause::kBegin));
  if (listeners_++ == 0) executor_.AddSink(this);
}

void EventStream::Remove(EventListener& listener) {
  if (--listeners_ == 0) executor_.RemoveSink(this);
  worker_->Remove(listener);
}

void EventStream::Flush() { worker_->Flush(); }

std::uint64_t EventStream::lost_ticks() const { return worker_->lost_ticks(); }

void EventStream::OnTick(const TickEvents& events) {
  if (lost_ticks_ == 0 && worker_->PushTick(events)) return;
  CountLost(events.tick);
  if (worker_->has_room_after_loss()) PushState(StreamState::Cause::kLost);
}

void EventStream::OnJump(const Executor&) { PushState(StreamState::Cause::kJump); }

void EventStream::CountLost(std::uint64_t tick) {
  if (lost_ticks_++ == 0) first_lost_ = tick;
  last_lost_ = tick;
  worker_->CountLost();
}

void EventStream::PushState(StreamState::Cause cause) {
  StreamState state = StateNow(cause);
  state.lost_ticks = std::exchange(lost_ticks_, 0);
  state.first_lost = first_lost_;
  state.last_lost = last_lost_;
  worker_->PushState(std::move(state));
}

StreamState EventStream::StateNow(StreamState::Cause cause) const {
  StreamState state;
  state.cause = cause;
  state.program = executor_.shared_program();
  state.tick = executor_.ticks();
  state.time = executor_.now();
  state.statuses = executor_.statuses();
  for (const Slot& slot : executor_.blackboard()) {
    state.values.emplace_back();
    AppendValueBytes(slot.value, state.values.back());
  }
  return state;
}

}  // namespace coppice
