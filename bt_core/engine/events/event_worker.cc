#include "bt_core/engine/events/event_worker.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

namespace coppice {
namespace {

// Between two looks at the ring. Without it, a fast tree would have to wake the worker in every
// tick.
constexpr std::chrono::microseconds kPause(500);

// What stands before the words of a tick in the ring.
struct Header {
  std::uint64_t tick;
  std::int64_t start;
  std::int64_t duration;
  std::uint32_t words;
  std::uint16_t result;
  std::uint16_t is_whole;
};
constexpr std::size_t kHeaderWords = sizeof(Header) / sizeof(std::uint32_t);
static_assert(sizeof(Header) == 32);

}  // namespace

EventWorker::EventWorker(std::size_t ring_words)
    : capacity_(ring_words), ring_(ring_words), thread_([this] { Work(); }) {}

EventWorker::~EventWorker() {
  Give(Order::Kind::kStop, nullptr);
  thread_.join();
}

bool EventWorker::PushTick(const TickEvents& events) {
  if (ring_.room() < kHeaderWords + events.words.size) return false;
  const Header header{events.tick,
                      ToNanoseconds(events.start),
                      events.duration.count(),
                      static_cast<std::uint32_t>(events.words.size),
                      static_cast<std::uint16_t>(events.result),
                      events.is_whole};
  std::uint32_t words[kHeaderWords];
  std::memcpy(words, &header, sizeof header);
  ring_.Push(words, kHeaderWords);
  ring_.Push(events.words.data, events.words.size);
  ring_.Publish();
  wake_up_.Notify();
  return true;
}

void EventWorker::PushState(StreamState state) {
  Give(Order::Kind::kState, nullptr, std::move(state));
}

void EventWorker::Add(EventListener& listener, StreamState state) {
  Give(Order::Kind::kAdd, &listener, std::move(state));
}

void EventWorker::Remove(EventListener& listener) { GiveAndWait(Order::Kind::kRemove, &listener); }

void EventWorker::Flush() { GiveAndWait(Order::Kind::kFlush, nullptr); }

void EventWorker::Give(Order::Kind kind, EventListener* listener, StreamState state) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    orders_.push_back({ring_.published(), kind, listener, std::move(state)});
    ++given_;
  }
  wake_up_.Notify();
}

void EventWorker::GiveAndWait(Order::Kind kind, EventListener* listener) {
  std::unique_lock<std::mutex> lock(mutex_);
  orders_.push_back({ring_.published(), kind, listener, {}});
  const std::uint64_t number = ++given_;
  wake_up_.Notify();
  was_done_.wait(lock, [&] { return done_ >= number; });
}

void EventWorker::Work() {
  pthread_setname_np(pthread_self(), "coppice_events");
  while (!stopped_) {
    wake_up_.WaitFor(std::chrono::nanoseconds::max());
    Drain();
    if (!stopped_) std::this_thread::sleep_for(kPause);
  }
}

void EventWorker::Drain() {
  ring_.PopAll(batch_);
  const std::uint32_t* at = batch_.data();
  const std::uint32_t* const end = at + batch_.size();
  while (at != end) {
    CarryOut(taken_);
    const std::size_t size = HandOver(at);
    at += size;
    taken_ += size;
  }
  CarryOut(taken_);
}

// The orders that were given before the words behind `position`.
void EventWorker::CarryOut(std::size_t position) {
  for (;;) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (orders_.empty() || orders_.front().position > position) return;
    const Order order = std::move(orders_.front());
    orders_.pop_front();
    lock.unlock();
    CarryOut(order);
    lock.lock();
    ++done_;
    was_done_.notify_all();
  }
}

void EventWorker::CarryOut(const Order& order) {
  switch (order.kind) {
    case Order::Kind::kState:
      for (EventListener* listener : listeners_) listener->OnState(order.state);
      return;
    case Order::Kind::kAdd:
      listeners_.push_back(order.listener);
      order.listener->OnState(order.state);
      return;
    case Order::Kind::kRemove:
      listeners_.erase(std::remove(listeners_.begin(), listeners_.end(), order.listener),
                       listeners_.end());
      return;
    case Order::Kind::kFlush:
      return;
    case Order::Kind::kStop:
      stopped_ = true;
  }
}

// Returns how many words the tick had.
std::size_t EventWorker::HandOver(const std::uint32_t* message) {
  Header header;
  std::memcpy(&header, message, sizeof header);
  const TickEvents events{header.tick,
                          TimeFromNanoseconds(header.start),
                          Duration(header.duration),
                          static_cast<Status>(header.result),
                          header.is_whole != 0,
                          {message + kHeaderWords, header.words}};
  for (EventListener* listener : listeners_) listener->OnTick(events);
  return kHeaderWords + header.words;
}

}  // namespace coppice
