// The writing half of a recorder: a queue of frames and a thread that brings them to the disk.
#ifndef COPPICE_BT_CORE_RECORD_RECORD_WRITER_H_
#define COPPICE_BT_CORE_RECORD_RECORD_WRITER_H_

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

#include "bt_core/base/outcome.h"
#include "bt_core/frames/history_encoder.h"
#include "bt_core/record/record_series.h"

namespace coppice {

struct RecorderOptions;

class RecordWriter final : private FrameSink {
 public:
  /// Makes the first file and starts the thread. Throws std::runtime_error.
  RecordWriter(const std::string& path, const RecorderOptions& options, HistoryOptions history);
  ~RecordWriter() override;
  RecordWriter(const RecordWriter&) = delete;
  RecordWriter& operator=(const RecordWriter&) = delete;

  /// Any thread, but in order. None of them waits for the disk: what finds no room is counted.
  void Add(const StreamState& state);
  void Add(const TickEvents& events);
  void Add(const HistoryNote& note);

  /// Writes everything that is left and an end at that time, and ends the thread.
  void Stop(Time now);

  /// Any thread.
  std::uint64_t lost_ticks() const { return lost_ticks_.load(std::memory_order_relaxed); }
  /// Any thread: number of the newest tick that the kernel has; 0 if none.
  std::uint64_t flushed_tick() const { return flushed_tick_.load(std::memory_order_acquire); }
  /// Any thread: what went wrong last, or empty.
  std::string error() const;
  /// Any thread: as Recorder.
  std::string trouble() const;

 private:
  // A run of frames for one file.
  struct Piece {
    bool begins_file = false;
    Bytes bytes;
    std::uint64_t tick = 0;  // the last one in it
  };

  // With the lock.
  void OnFrame(const Frame& frame) override;
  bool HasRoom() const { return waiting_ < buffer_bytes_; }
  void GoOnInAnotherFileIfDue(Time time);

  // Of the thread.
  void Run();
  bool WaitForWork();
  void Drain();
  bool Take();
  bool Write();
  bool WriteFront();
  void SyncIfDue(bool now);
  void Report(const Outcome& outcome);

  const std::size_t buffer_bytes_;
  const std::uint64_t max_file_bytes_;
  const Duration flush_period_;
  const Duration sync_period_;
  const Duration deletion_told_;

  std::atomic<std::uint64_t> lost_ticks_{0};
  std::atomic<std::uint64_t> flushed_tick_{0};

  mutable std::mutex mutex_;  // of what follows; never held while the disk works
  std::condition_variable wake_;
  bool stop_ = false;
  bool hurry_ = false;
  HistoryEncoder encoder_;
  std::deque<Piece> queue_;
  std::size_t waiting_ = 0;        // bytes in the queue and in the thread's hands
  std::uint64_t file_bytes_ = 0;   // of the file that the queue ends in
  std::uint64_t start_bytes_ = 0;  // of these, until reading can begin
  bool is_deleted_ = false;        // the present file
  std::string error_;
  std::string trouble_;
  std::string deletion_;  // of a file of this record, the last
  std::chrono::steady_clock::time_point deleted_;

  // Of the thread.
  RecordSeries series_;
  std::deque<Piece> pending_;  // taken, not yet in the kernel
  bool unsynced_ = false;
  std::chrono::steady_clock::time_point synced_;
  std::thread thread_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_RECORD_WRITER_H_
