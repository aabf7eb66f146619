// The history of a short run as a robot stores it.
#ifndef COPPICE_TESTS_BT_CORE_LIVE_ENCODED_RUN_H_
#define COPPICE_TESTS_BT_CORE_LIVE_ENCODED_RUN_H_

#include <string>
#include <vector>

#include "bt_core/engine/events/event_stream.h"
#include "bt_core/frames/history_encoder.h"
#include "tests/bt_core/live/watched_tree.h"

namespace coppice {

/// Its frames: 0 the tree, 1 the state, then one for each tick.
class EncodedRun : private FrameSink, private EventListener {
 public:
  explicit EncodedRun(int ticks) {
    stream_.Add(*this);
    for (int i = 0; i < ticks; ++i) {
      executor_.Tick();
      stream_.Flush();
      encoder_.Flush();
    }
    stream_.Flush();  // the state comes even without a tick
    encoder_.Keyframe();
    stream_.Remove(*this);
  }
  std::string operator[](std::size_t i) const { return frames_.at(i); }
  std::size_t size() const { return frames_.size(); }

 private:
  void OnFrame(const Frame& frame) override {
    frames_.emplace_back(reinterpret_cast<const char*>(frame.data), frame.size);
  }
  void OnState(const StreamState& state) override { encoder_.Add(state); }
  void OnTick(const TickEvents& events) override { encoder_.Add(events); }

  SimulatedClock clock_;
  Executor executor_{WatchedProgram(), clock_};
  EventStream stream_{executor_};
  HistoryEncoder encoder_{{}, *this};
  std::vector<std::string> frames_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_LIVE_ENCODED_RUN_H_
