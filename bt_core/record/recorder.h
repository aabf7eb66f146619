// Records a running tree in a file: every tick with everything that happened in it.
//
//   Executor executor(program, clock);
//   EventStream stream(executor);
//   Recorder recorder(stream, "run.coppice", {{{"robot", "sobi-1"}}});
//   ... tick ...                                     // `coppice replay run.coppice` prints it
//
// Recording cannot slow or stop the tree, nor others who listen to the stream: the events are
// encoded on the thread of the stream, and a thread of the recorder writes. If the disk is too
// slow, ticks are left out, and the record says how many. At most the last 100 ms are lost when the
// program is killed, at most about a second when the power fails, nothing at an orderly end. The
// file is described in docs/record_format.md.
#ifndef COPPICE_BT_CORE_RECORD_RECORDER_H_
#define COPPICE_BT_CORE_RECORD_RECORDER_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "bt_core/base/outcome.h"
#include "bt_core/engine/events/event_stream.h"
#include "bt_core/frames/history_encoder.h"

namespace coppice {

class RecordWriter;

struct RecorderOptions {
  /// What the application wants to be known of this run.
  Metadata metadata;
  /// Which clock the tree's times are of; empty: "wall", "simulated" or "own".
  std::string clock;
  /// Zeros: a new one.
  RunId run{};
  /// How much may wait for the disk [bytes].
  std::size_t buffer_bytes = 4 << 20;
  /// Events reach the kernel at least this often.
  Duration flush_period = std::chrono::milliseconds(50);
  /// Events reach the disk at least this often.
  Duration sync_period = std::chrono::seconds(1);
  /// So long trouble() tells of a file that somebody has deleted.
  Duration deletion_told = std::chrono::minutes(1);
  /// A file that is as long as this is closed, and the record goes on in another: run.coppice,
  /// run.2.coppice, run.3.coppice... Each can be read alone. 0: one file of any length.
  std::uint64_t max_file_bytes = 0;
  /// Of so many files the oldest is removed when another begins. 0: all are kept.
  std::uint32_t keep_files = 0;
};

class Recorder final : public EventListener {
 public:
  /// On the ticking thread, between ticks; so are Close and the destructor. The stream must live
  /// longer. Throws std::runtime_error if the file cannot be written or is there already.
  Recorder(EventStream& stream, const std::string& path, const RecorderOptions& options = {});
  ~Recorder() override;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Any thread: something that happened around the tree, for example an injected fault. `time` is
  /// of the tree's clock. It stands behind the ticks that the recorder has got.
  void Note(Time time, std::string kind, std::string text);

  /// Ends the recording; waits until everything is on the disk. A problem if something was lost.
  Outcome Close();

  /// Any thread: ticks that are not in the record because the disk was too slow (or the stream had
  /// lost them before).
  std::uint64_t lost_ticks() const;
  /// Any thread: the newest tick that survives when this program is killed; 0 if none.
  std::uint64_t flushed_tick() const;
  /// Any thread: what went wrong last, or empty.
  std::string error() const;
  /// Any thread: why it cannot write now, or that its file was deleted a while ago, or empty. It
  /// tries again and again.
  std::string trouble() const;

  void OnState(const StreamState& state) override;
  void OnTick(const TickEvents& events) override;

 private:
  EventStream& stream_;
  std::unique_ptr<RecordWriter> writer_;
  bool closed_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_RECORDER_H_
