// The writing half of a recorder: a thread that brings frames from a ring to a file.
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

#include "bt_core/record/byte_ring.h"
#include "bt_core/record/entries.h"
#include "bt_core/record/record_file.h"

namespace coppice {

class RecordWriter {
 public:
  struct Periods {
    Duration flush;  ///< between writes to the kernel
    Duration sync;   ///< between waits for the disk
  };

  /// Makes the file with these bytes at its start and starts the thread. Throws
  /// std::runtime_error.
  RecordWriter(const std::string& path, Bytes start, std::size_t buffer_bytes, Periods periods);
  ~RecordWriter();
  RecordWriter(const RecordWriter&) = delete;
  RecordWriter& operator=(const RecordWriter&) = delete;

  /// Ticking thread: closed frames, without their checksums, of which each begins with a time. All
  /// or nothing; false if there is no room. Neither waits nor allocates.
  bool Push(const Bytes& frames);
  std::size_t room() const { return ring_.capacity() - ring_.size(); }
  std::size_t capacity() const { return ring_.capacity(); }

  /// Any thread. Written between the frames according to its time; counted if there is no room.
  void PushNote(RecordedNote note);
  std::uint64_t lost_notes() const { return lost_notes_.load(std::memory_order_relaxed); }
  void ForgetLostNotes(std::uint64_t count) { lost_notes_ -= count; }

  /// Ticking thread: writes everything that is left, then these frames, and ends the thread.
  void Stop(const Bytes& last_frames);

  /// Any thread: number of the newest tick that the kernel has; 0 if none.
  std::uint64_t flushed_tick() const { return flushed_tick_.load(std::memory_order_acquire); }
  /// Any thread: what went wrong last, or empty.
  std::string error() const;

 private:
  void Run();
  bool WaitForWork();
  void Drain();
  void Gather();
  void AppendNotesUntil(Time time);
  void AppendSealed(Bytes& frames);
  bool Flush();
  void SyncIfDue(bool now);
  void Report(const std::string& error);

  RecordFile file_;
  const Periods periods_;
  ByteRing ring_;
  std::atomic<bool> hurry_{false};
  std::atomic<std::uint64_t> lost_notes_{0};
  std::atomic<std::uint64_t> flushed_tick_{0};

  mutable std::mutex mutex_;  // of what follows; the ticking thread takes it only in Stop
  std::condition_variable wake_;
  bool stop_ = false;
  Bytes last_frames_;
  std::deque<RecordedNote> notes_;
  std::size_t note_bytes_ = 0;
  std::string error_;

  // Of the thread.
  std::deque<RecordedNote> taken_notes_;
  Bytes batch_;
  Bytes pending_;  // sealed, not yet in the kernel
  std::uint64_t newest_tick_ = 0;
  bool unsynced_ = false;
  std::chrono::steady_clock::time_point synced_;
  std::thread thread_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_RECORD_WRITER_H_
