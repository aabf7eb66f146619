// Brings the events of a tree from the ticking thread to everyone else: live view, recorder,
// statistics.
//
//   EventStream stream(executor);
//   Recorder recorder(stream, "run.coppice");
//   LivePublisher live(stream);
//
// The ticking thread copies the words of each tick into a ring that was allocated before; a thread
// of the stream hands them to the listeners. The tick never waits: if a listener is too slow and
// the ring is full, ticks are left out, and the listeners are told how many and how the tree stands
// behind the gap. While there is no listener, nothing is collected.
#ifndef COPPICE_BT_CORE_ENGINE_EVENTS_EVENT_STREAM_H_
#define COPPICE_BT_CORE_ENGINE_EVENTS_EVENT_STREAM_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bt_core/engine/executor.h"

namespace coppice {

/// How a tree stands: what a listener needs to follow it from here on.
struct StreamState {
  enum class Cause : std::uint8_t {
    kBegin,  ///< the first call of this listener
    kLost,   ///< events are missing before this
    kJump,   ///< the tree was given another program or another state
  };
  Cause cause = Cause::kBegin;
  std::shared_ptr<const Program> program;
  std::uint64_t tick = 0;  ///< number of the last tick
  Time time{};             ///< in the tree's clock
  std::vector<Status> statuses;
  std::vector<std::string> values;  ///< per slot, as in data/value_bytes.h
  std::uint64_t lost_ticks = 0;     ///< missing before this: number, first and last
  std::uint64_t first_lost = 0;
  std::uint64_t last_lost = 0;
};

/// Called on the thread of the stream, one call at a time; must not throw.
class EventListener {
 public:
  virtual ~EventListener() = default;
  virtual void OnState(const StreamState& state) = 0;
  virtual void OnTick(const TickEvents& events) = 0;
};

class EventWorker;

class EventStream final : public TickSink {
 public:
  static constexpr std::size_t kDefaultRingBytes = 8 << 20;

  /// The executor must live longer. All functions are called on the ticking thread, between ticks,
  /// unless they say otherwise.
  explicit EventStream(Executor& executor, std::size_t ring_bytes = kDefaultRingBytes);
  ~EventStream() override;
  EventStream(const EventStream&) = delete;
  EventStream& operator=(const EventStream&) = delete;

  /// The listener gets the present state and then every tick. It must live until it is removed.
  void Add(EventListener& listener);
  /// First hands it everything that has happened.
  void Remove(EventListener& listener);

  Executor& executor() { return executor_; }

  /// Any thread but that of the stream: returns when the listeners have got everything that had
  /// happened.
  void Flush();

  /// Any thread: ticks that were left out because listeners were too slow.
  std::uint64_t lost_ticks() const;

  void OnTick(const TickEvents& events) override;
  void OnJump(const Executor&) override;

 private:
  StreamState StateNow(StreamState::Cause cause) const;
  void CountLost(std::uint64_t tick);
  void PushState(StreamState::Cause cause);

  Executor& executor_;
  std::size_t listeners_ = 0;
  std::uint64_t lost_ticks_ = 0;  // since the listeners were told
  std::uint64_t first_lost_ = 0;
  std::uint64_t last_lost_ = 0;
  std::unique_ptr<EventWorker> worker_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EVENTS_EVENT_STREAM_H_
