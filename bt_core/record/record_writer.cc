#include "bt_core/record/record_writer.h"

#include <pthread.h>
#include <signal.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "bt_core/record/entry_coding.h"
#include "bt_core/history/frame.h"

namespace coppice {
namespace {

constexpr std::size_t kMaxNoteBytes = 4 << 20;

std::size_t SizeOf(const RecordedNote& note) {
  return sizeof(note) + note.kind.size() + note.text.size();
}

// Signals are for the threads of the application; a pipe without reader is an error, not a signal.
void BlockSignals() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

RecordWriter::RecordWriter(const std::string& path, Bytes start, std::size_t buffer_bytes,
                           Periods periods)
    : file_(path),
      periods_(periods),
      ring_(std::min(buffer_bytes, kMaxPayloadSize)),
      synced_(std::chrono::steady_clock::now()) {
  const std::string error = file_.Write(start);
  if (!error.empty()) throw std::runtime_error(error);
  thread_ = std::thread([this] { Run(); });
}

RecordWriter::~RecordWriter() { Stop({}); }

bool RecordWriter::Push(const Bytes& frames) {
  const bool pushed = ring_.Push(frames.data(), frames.size());
  if (!pushed || ring_.size() > ring_.capacity() / 2) {
    hurry_.store(true, std::memory_order_relaxed);
    wake_.notify_one();  // missed if the thread is just going to wait: then it waits one period
  }
  return pushed;
}

void RecordWriter::PushNote(RecordedNote note) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (stop_ || note_bytes_ + SizeOf(note) > kMaxNoteBytes) {
    ++lost_notes_;
    return;
  }
  note_bytes_ += SizeOf(note);
  notes_.push_back(std::move(note));
}

void RecordWriter::Stop(const Bytes& last_frames) {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    last_frames_ = last_frames;
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

std::string RecordWriter::error() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return error_;
}

void RecordWriter::Run() {
  pthread_setname_np(pthread_self(), "coppice_record");
  BlockSignals();
  while (WaitForWork()) {
    Drain();
    SyncIfDue(false);
  }
  Drain();
  AppendNotesUntil(kNever);
  AppendSealed(last_frames_);
  Flush();
  SyncIfDue(true);
}

// False when it is time to end.
bool RecordWriter::WaitForWork() {
  std::unique_lock<std::mutex> lock(mutex_);
  wake_.wait_for(lock, periods_.flush, [this] { return stop_ || hurry_.load(); });
  hurry_ = false;
  return !stop_;
}

// New frames are taken only when the old ones are written, so that a slow disk fills the ring and
// not the memory.
void RecordWriter::Drain() {
  if (!Flush()) return;
  Gather();
  Flush();
}

void RecordWriter::Gather() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    taken_notes_.insert(taken_notes_.end(), std::make_move_iterator(notes_.begin()),
                        std::make_move_iterator(notes_.end()));
    notes_.clear();
    note_bytes_ = 0;
  }
  batch_.clear();
  ring_.PopAll(batch_);
  AppendSealed(batch_);
  AppendNotesUntil(kNever);
}

void RecordWriter::AppendSealed(Bytes& frames) {
  for (std::size_t at = 0; at < frames.size();) {
    const std::size_t size = SealFrame(frames.data() + at);
    const std::uint8_t* payload = frames.data() + at + kFrameHeaderSize;
    Decoder decoder(payload, payload + size - kFrameHeaderSize);
    AppendNotesUntil(decoder.At());
    const FrameHeader header = ReadFrameHeader(frames.data() + at);
    if (header.type == static_cast<std::uint8_t>(FrameType::kTick)) {
      newest_tick_ = decoder.Unsigned();
    }
    const auto begin = frames.begin() + static_cast<std::ptrdiff_t>(at);
    pending_.insert(pending_.end(), begin, begin + static_cast<std::ptrdiff_t>(size));
    at += size;
  }
}

void RecordWriter::AppendNotesUntil(Time time) {
  while (!taken_notes_.empty() && taken_notes_.front().time <= time) {
    const std::size_t frame = OpenFrame(pending_, FrameType::kNote);
    Encoder encoder(pending_);
    EncodeNote(taken_notes_.front(), encoder);
    CloseFrame(pending_, frame);
    SealFrame(pending_.data() + frame);
    taken_notes_.pop_front();
  }
}

// True if nothing is left to write.
bool RecordWriter::Flush() {
  if (pending_.empty()) return true;
  Report(file_.Write(pending_));
  unsynced_ = true;
  if (!pending_.empty()) return false;
  flushed_tick_.store(newest_tick_, std::memory_order_release);
  return true;
}

void RecordWriter::SyncIfDue(bool now) {
  const auto time = std::chrono::steady_clock::now();
  if (!unsynced_ || (!now && time - synced_ < periods_.sync)) return;
  Report(file_.Sync());
  synced_ = time;
  unsynced_ = false;
}

void RecordWriter::Report(const std::string& error) {
  if (error.empty()) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  error_ = error;
}

}  // namespace coppice
