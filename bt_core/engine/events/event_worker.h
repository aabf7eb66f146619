// The other side of an EventStream: takes ticks out of the ring in a thread of its own and hands
// them to the listeners.
#ifndef COPPICE_BT_CORE_ENGINE_EVENTS_EVENT_WORKER_H_
#define COPPICE_BT_CORE_ENGINE_EVENTS_EVENT_WORKER_H_

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

#include "bt_core/base/wake_up.h"
#include "bt_core/engine/events/event_stream.h"
#include "bt_core/engine/events/word_ring.h"

namespace coppice {

class EventWorker {
 public:
  explicit EventWorker(std::size_t ring_words);
  /// Hands over what is there first.
  ~EventWorker();
  EventWorker(const EventWorker&) = delete;
  EventWorker& operator=(const EventWorker&) = delete;

  /// Ticking thread: false if there is no room. Neither waits nor allocates.
  bool PushTick(const TickEvents& events);
  /// Ticking thread: enough was taken out that it is worth going on after a loss.
  bool has_room_after_loss() const { return ring_.room() >= capacity_ / 2; }
  /// Ticking thread: everyone gets this state behind the ticks that were pushed so far.
  void PushState(StreamState state);

  void CountLost() { lost_ticks_.fetch_add(1, std::memory_order_relaxed); }
  std::uint64_t lost_ticks() const { return lost_ticks_.load(std::memory_order_relaxed); }

  /// From now on the listener gets everything, first this state.
  void Add(EventListener& listener, StreamState state);
  /// Returns when the listener has got everything that was pushed, and gets nothing any more.
  void Remove(EventListener& listener);
  /// Returns when everything that was pushed has been handed over.
  void Flush();

 private:
  // Something that is done behind so many words of the ring.
  struct Order {
    enum class Kind : std::uint8_t { kState, kAdd, kRemove, kFlush, kStop };
    std::size_t position;
    Kind kind;
    EventListener* listener;
    StreamState state;
  };

  void Give(Order::Kind kind, EventListener* listener, StreamState state = {});
  void GiveAndWait(Order::Kind kind, EventListener* listener);
  void Work();
  void Drain();
  void CarryOut(std::size_t position);
  void CarryOut(const Order& order);
  std::size_t HandOver(const std::uint32_t* message);

  const std::size_t capacity_;
  WordRing ring_;
  WakeUp wake_up_;
  std::atomic<std::uint64_t> lost_ticks_{0};

  std::mutex mutex_;  // for the next three; held for moments only
  std::deque<Order> orders_;
  std::uint64_t given_ = 0;
  std::uint64_t done_ = 0;
  std::condition_variable was_done_;

  std::vector<EventListener*> listeners_;  // from here on: of the worker's thread
  std::vector<std::uint32_t> batch_;
  std::size_t taken_ = 0;  // words ever taken out of the ring
  bool stopped_ = false;
  std::thread thread_;  // last: starts when the rest is there
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EVENTS_EVENT_WORKER_H_
