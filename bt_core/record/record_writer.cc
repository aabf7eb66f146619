#include "bt_core/record/record_writer.h"

#include <pthread.h>
#include <signal.h>

#include <utility>

#include "bt_core/record/recorder.h"

namespace coppice {
namespace {

// Signals are for the threads of the application; a pipe without reader is an error, not a signal.
void BlockSignals() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

RecordWriter::RecordWriter(const std::string& path, const RecorderOptions& options,
                           HistoryOptions history)
    : buffer_bytes_(options.buffer_bytes),
      max_file_bytes_(options.max_file_bytes),
      flush_period_(options.flush_period),
      sync_period_(options.sync_period),
      deletion_told_(options.deletion_told),
      encoder_(std::move(history), *this),
      series_(path, options.keep_files),
      synced_(std::chrono::steady_clock::now()) {
  thread_ = std::thread([this] { Run(); });
}

RecordWriter::~RecordWriter() {
  if (thread_.joinable()) Stop(Time{});
}

void RecordWriter::Add(const StreamState& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  lost_ticks_ += state.lost_ticks;
  if (HasRoom()) {
    encoder_.Add(state);
  } else {
    encoder_.Skip(state);
  }
  if (start_bytes_ == 0) start_bytes_ = file_bytes_;
}

void RecordWriter::Add(const TickEvents& events) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!HasRoom()) {
    lost_ticks_ += events.is_whole;
    return encoder_.Skip(events);
  }
  encoder_.Add(events);
  if (events.is_whole) GoOnInAnotherFileIfDue(events.start);
}

void RecordWriter::Add(const HistoryNote& note) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (stop_ || !HasRoom()) return encoder_.SkipNotes(1);
  encoder_.Note(note);
}

void RecordWriter::OnFrame(const Frame& frame) {
  if (queue_.empty()) queue_.emplace_back();
  Piece& piece = queue_.back();
  piece.bytes.insert(piece.bytes.end(), frame.data, frame.data + frame.size);
  piece.tick = frame.tick;
  waiting_ += frame.size;
  file_bytes_ += frame.size;
  if (waiting_ < buffer_bytes_ / 2 || hurry_) return;
  hurry_ = true;
  wake_.notify_one();
}

// A file that holds less than it needs to begin with would only be followed by another such file.
void RecordWriter::GoOnInAnotherFileIfDue(Time time) {
  const bool is_full =
      max_file_bytes_ > 0 && file_bytes_ >= max_file_bytes_ && file_bytes_ >= 2 * start_bytes_;
  if (!is_full && !std::exchange(is_deleted_, false)) return;
  encoder_.End(HistoryEnd::Cause::kContinued, time);
  queue_.emplace_back();
  queue_.back().begins_file = true;
  file_bytes_ = 0;
  encoder_.Begin();
  start_bytes_ = file_bytes_;
}

void RecordWriter::Stop(Time now) {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    encoder_.End(HistoryEnd::Cause::kClosed, now);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

std::string RecordWriter::error() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return error_;
}

std::string RecordWriter::trouble() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!trouble_.empty()) return trouble_;
  return std::chrono::steady_clock::now() - deleted_ < deletion_told_ ? deletion_ : "";
}

void RecordWriter::Run() {
  pthread_setname_np(pthread_self(), "coppice_record");
  BlockSignals();
  while (WaitForWork()) {
    Drain();
    SyncIfDue(false);
  }
  Drain();
  SyncIfDue(true);
}

// False when it is time to end.
bool RecordWriter::WaitForWork() {
  std::unique_lock<std::mutex> lock(mutex_);
  wake_.wait_for(lock, flush_period_, [this] { return stop_ || hurry_; });
  return !stop_;
}

// New frames are taken only when the old ones are written, so that a slow disk fills the queue and
// not the memory.
void RecordWriter::Drain() {
  while (Write() && Take()) {
  }
}

// False if there is nothing.
bool RecordWriter::Take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  encoder_.Flush();
  hurry_ = false;
  pending_ = std::exchange(queue_, {});
  return !pending_.empty();
}

// True if nothing is left to write.
bool RecordWriter::Write() {
  while (!pending_.empty()) {
    if (!WriteFront()) return false;
    pending_.pop_front();
  }
  return true;
}

bool RecordWriter::WriteFront() {
  Piece& piece = pending_.front();
  if (std::exchange(piece.begins_file, false)) Report(series_.Next());
  const std::size_t size = piece.bytes.size();
  const Outcome written = series_.Write(piece.bytes);
  unsynced_ = true;
  Report(written);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_ -= size - piece.bytes.size();
    if (written && !series_.is_deleted()) trouble_.clear();  // else it is lost all the same
    hurry_ = false;  // what did not work is tried again after a while
  }
  if (!piece.bytes.empty()) return false;
  flushed_tick_.store(piece.tick, std::memory_order_release);
  return true;
}

void RecordWriter::SyncIfDue(bool now) {
  const auto time = std::chrono::steady_clock::now();
  if (!unsynced_ || (!now && time - synced_ < sync_period_)) return;
  const Outcome synced = series_.Sync();
  synced_ = time;
  unsynced_ = false;
  const std::lock_guard<std::mutex> lock(mutex_);
  is_deleted_ = series_.is_deleted();
  if (synced) return;
  error_ = synced.problem();
  (is_deleted_ ? deletion_ : trouble_) = error_;
  if (is_deleted_) deleted_ = time;
}

void RecordWriter::Report(const Outcome& outcome) {
  if (outcome) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  error_ = trouble_ = outcome.problem();
}

}  // namespace coppice
