// One tree of a live view, as the threads of the view know it: fed by the event stream, asked by
// the server. The ticking thread comes here only when a debugger stops the tree.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_LIVE_TREE_H_
#define COPPICE_BT_CORE_LIVE_SERVER_LIVE_TREE_H_

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "bt_core/engine/events/event_stream.h"
#include "bt_core/frames/history_encoder.h"
#include "bt_core/live/debug/debugger.h"
#include "bt_core/live/groot2/groot2_protocol.h"
#include "bt_core/live/groot2/transitions.h"
#include "bt_core/live/server/frame_store.h"
#include "bt_core/live/server/live_options.h"

namespace coppice {

/// How often a node returned RUNNING, SUCCESS, FAILURE, SKIPPED.
using ResultCounts = std::array<std::uint64_t, 4>;

/// What holds of a tree between two of its ticks.
struct LiveTreeInfo {
  std::string name;
  RunId run{};
  std::size_t nodes = 0;
  std::uint64_t tick = 0;
  std::uint64_t first_frame = 0;
  std::uint64_t next_frame = 0;
  std::uint64_t lost_ticks = 0;
  std::uint64_t recording_dropped = 0;
};

/// Statuses or values with the program that they belong to.
template <class T>
struct OfProgram {
  std::shared_ptr<const Program> program;
  std::vector<T> items;
};

class LiveTree final : public EventListener, private FrameSink {
 public:
  /// The owner of what waits for the first client; those of others are larger.
  static constexpr OwnerId kWaitOwner = 1;
  static constexpr OwnerId kGroot2Owner = 2;
  static constexpr OwnerId kFirstClientOwner = 16;

  /// `wake` is called, on any thread, when there is something to send. Ticking thread, between
  /// ticks.
  LiveTree(EventStream& stream, LiveTreeOptions options, std::function<void()> wake);

  void OnState(const StreamState& state) override;
  void OnTick(const TickEvents& events) override;

  // The thread of the server.
  const LiveTreeOptions& options() const { return options_; }
  Debugger& debugger() { return debugger_; }
  /// Whether somebody may stop and change it now.
  Outcome Permission() const;

  const RunId& run() const { return run_.run; }
  LiveTreeInfo Info() const;
  std::shared_ptr<const Program> program() const;
  /// Another one whenever the program is another one.
  groot2::TreeId id() const;
  /// Per node, as the Groot2 protocol shows it: 10 + the status before, if it is idle now.
  OfProgram<std::uint8_t> ShownStatuses() const;
  /// Per slot, as in data/value_bytes.h.
  OfProgram<std::string> Values() const;
  OfProgram<ResultCounts> Counts() const;

  /// Microseconds since 1970 that the times of the recording are counted from.
  std::uint64_t StartRecording();
  void StopRecording();
  std::string TakeTransitions();

  /// Has the value written before the next tick. Either the text of a JSON value or, with
  /// `is_text`, what a literal in the XML would be.
  Outcome Write(const std::string& scope, const std::string& key, const std::string& value,
                bool is_text);

  /// Calls `use` with all frames so far. While no one subscribes frames are made of many ticks.
  template <class Use>
  auto UseFrames(const Use& use);
  void CountSubscribers(int by) { subscribers_ += by; }
  /// The run has ended: the last frame says so.
  void EndHistory();

  /// What a debugger has told since the last call; and whether the program is another one.
  std::vector<DebugEvent> TakeDebugEvents();
  bool TakeProgramChange() { return program_changed_.exchange(false); }

 private:
  void OnFrame(const Frame& frame) override;
  void OnDebugEvent(const DebugEvent& event);
  void NotePause();
  void SetProgram(std::shared_ptr<const Program> program);
  void Count(const TickEvents& events);

  const LiveTreeOptions options_;
  const std::function<void()> wake_;
  EventStream& stream_;
  Clock& clock_;
  Executor& executor_;  // for the calls that are posted to its inbox
  const std::shared_ptr<Inbox> inbox_;
  struct Stop {
    Time at{};
    std::chrono::steady_clock::time_point real{};
    DebugStop where;
  };
  Stop stopped_;  // the ticking thread: when the tree was stopped last
  const RunInfo run_;
  std::atomic<int> subscribers_{0};
  std::atomic<bool> program_changed_{false};

  mutable std::mutex mutex_;  // guards what follows
  FrameStore frames_;
  HistoryEncoder encoder_;
  std::shared_ptr<const Program> program_;
  groot2::TreeId id_ = groot2::RandomTreeId();
  std::vector<ResultCounts> counts_;
  Transitions transitions_;
  std::uint64_t lost_ticks_ = 0;
  bool ended_ = false;

  std::mutex debug_mutex_;
  std::vector<DebugEvent> debug_events_;
  Debugger debugger_;  // last: tells of events
};

template <class Use>
auto LiveTree::UseFrames(const Use& use) {
  const std::lock_guard<std::mutex> lock(mutex_);
  encoder_.Flush();
  return use(frames_);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_LIVE_TREE_H_
