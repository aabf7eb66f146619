// Records a running tree in a file: every change of status, every blackboard write, every message,
// tick by tick.
//
//   Executor executor(program, clock);
//   Recorder recorder(executor, "run.coppice", {{{"robot", "sobi-1"}}});
//   ... tick ...                                     // `coppice replay run.coppice` prints it
//
// Recording cannot slow or stop the tree: the ticking thread encodes into a ring that was allocated
// before, and a thread of the recorder writes. If the disk is too slow, ticks are left out, and the
// record says how many. At most the last 100 ms are lost when the program is killed, at most about
// a second when the power fails, nothing at an orderly end. The file is described in
// docs/record_format.md.
#ifndef COPPICE_BT_CORE_RECORD_RECORDER_H_
#define COPPICE_BT_CORE_RECORD_RECORDER_H_

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "bt_core/engine/executor.h"
#include "bt_core/record/coding.h"
#include "bt_core/record/entries.h"

namespace coppice {

class RecordWriter;

struct RecorderOptions {
  /// What the application wants to be known of this run.
  Metadata metadata;
  /// How much the ticking thread may be ahead of the disk [bytes].
  std::size_t buffer_bytes = 4 << 20;
  /// Events reach the kernel at least this often.
  Duration flush_period = std::chrono::milliseconds(50);
  /// Events reach the disk at least this often.
  Duration sync_period = std::chrono::seconds(1);
};

class Recorder final : public TickSink {
 public:
  /// Between ticks, on the ticking thread; so are Close and the destructor. The executor must live
  /// longer. Throws std::runtime_error if the file cannot be written or is there already.
  Recorder(Executor& executor, const std::string& path, const RecorderOptions& options = {});
  ~Recorder() override;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Any thread: something that happened around the tree, for example an injected fault. `time` is
  /// of the tree's clock.
  void Note(Time time, std::string kind, std::string text);

  /// Ends the recording; waits until everything is on the disk. An error text, or empty if nothing
  /// was lost.
  std::string Close();

  /// Any thread: ticks with events that were left out because the disk was too slow.
  std::uint64_t lost_ticks() const { return lost_ticks_.load(std::memory_order_relaxed); }
  /// Any thread: the newest tick that survives when this program is killed; 0 if none.
  std::uint64_t flushed_tick() const;
  /// Any thread: what went wrong last, or empty.
  std::string error() const;

  void OnTick(const TickEvents& events) override;

 private:
  bool PushTick(const TickEvents& events);
  void AppendGap(Time time);
  void CountLost(std::uint64_t tick);

  Executor& executor_;
  std::unique_ptr<RecordWriter> writer_;
  Bytes frames_;
  RecordedGap gap_;              // what was lost since the last gap frame
  std::size_t needed_room_ = 0;  // for the frames that found no room last time
  std::atomic<std::uint64_t> lost_ticks_{0};
  bool closed_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_RECORDER_H_
