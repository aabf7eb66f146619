#include "bt_core/cli/live/remote_recorder.h"

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "bt_core/frames/frame.h"
#include "bt_core/frames/payload_coding.h"
#include "bt_core/live/groot2/client_robot_tree.h"

namespace coppice {
namespace {

constexpr auto kSyncPeriod = std::chrono::seconds(1);

template <class Value>
Bytes MakeFrame(FrameType type, void (*encode)(const Value&, Encoder&), const Value& value) {
  Bytes frame;
  OpenFrame(frame, type);
  Encoder encoder(frame);
  encode(value, encoder);
  CloseFrame(frame, 0);
  SealFrame(frame.data());
  return frame;
}

// "demo.run2.coppice" for "demo.coppice".
std::string PathOfRun(const std::filesystem::path& path, int run) {
  std::filesystem::path result = path;
  return result.replace_extension(".run" + std::to_string(run) + path.extension().string());
}

}  // namespace

RemoteRecorder::RemoteRecorder(const std::string& path, const RemoteRecorderOptions& options)
    : path_(path),
      options_(options),
      series_(std::make_unique<RecordSeries>(path, options.keep_files)) {}

RemoteRecorder::Counts RemoteRecorder::counts() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return counts_;
}

std::string RemoteRecorder::error() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return error_;
}

LiveConnection RemoteRecorder::connection() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return connection_;
}

void RemoteRecorder::Close() {
  if (has_frames_ && !has_ended_) {
    const HistoryEnd end = {HistoryEnd::Cause::kClosed, time_, tick_};
    Append(MakeFrame(FrameType::kEnd, EncodeEnd, end));
  }
  Write();
  Report(series_->Sync());
}

void RemoteRecorder::OnConnection(const LiveConnection& connection) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    connection_ = connection;
  }
  if (!connection.is_live) {
    if (was_live_) Note("the connection is lost: " + connection.problem);
    was_live_ = false;
    return;
  }
  is_groot2_ = connection.protocol == LiveConnection::Protocol::kGroot2;
  if (connection.run == run_ && has_frames_ && !was_live_) Note("the connection is back");
  was_live_ = true;
  if (connection.run == run_) return;
  run_ = connection.run;
  if (has_frames_ && !is_groot2_) BeginRecord();
  const std::lock_guard<std::mutex> lock(mutex_);
  ++counts_.runs;
}

void RemoteRecorder::OnTree(const TreeDescription& tree) { described_ = tree; }

// A Groot2 robot tells tree and state before the client says that it is live.
void RemoteRecorder::OnState(const HistoryState& state) {
  time_ = state.time;
  tick_ = state.tick;
  const bool is_described = described_ && described_->writer == kGroot2Writer;
  if (!is_described) return;
  const bool is_other_run = described_->info.run != run_;
  if (has_frames_ && is_other_run) BeginRecord();
  if (!encoder_ || is_other_run) {
    HistoryOptions history;
    history.info = described_->info;
    FrameSink& sink = *this;
    encoder_ = std::make_unique<HistoryEncoder>(history, sink);
  }
  encoder_->Add(*described_, state);
}

void RemoteRecorder::OnTick(const TickEvents& events) {
  time_ = events.start;
  tick_ = events.tick;
  if (encoder_ && is_groot2_) {
    encoder_->Add(events);
    encoder_->Flush();
  }
  if (!events.is_whole || events.result == Status::kIdle) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  ++counts_.ticks;
}

void RemoteRecorder::OnGap(const HistoryGap& gap) {
  if (encoder_ && is_groot2_) Append(MakeFrame(FrameType::kGap, EncodeGap, gap));
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.lost_ticks += gap.lost_ticks;
}

void RemoteRecorder::OnFrame(const Frame& frame) { Take(frame.data, frame.size); }

void RemoteRecorder::OnFrame(const std::uint8_t* frame, std::size_t size) { Take(frame, size); }

void RemoteRecorder::Take(const std::uint8_t* data, std::size_t size) {
  const Bytes frame(data, data + size);
  const auto type = static_cast<FrameType>(ReadFrameHeader(data).type);
  if (type == FrameType::kTree) tree_frame_ = frame;
  const bool is_long = options_.max_file_bytes > 0 && file_bytes_ >= options_.max_file_bytes;
  if (type == FrameType::kState && is_long) {
    const HistoryEnd end = {HistoryEnd::Cause::kContinued, time_, tick_};
    Append(MakeFrame(FrameType::kEnd, EncodeEnd, end));
    BeginFile();
    Append(tree_frame_);
  }
  Append(frame);
  has_ended_ = type == FrameType::kEnd;
  Write();
}

void RemoteRecorder::BeginFile() {
  Write();
  Report(series_->Sync());
  Report(series_->Next());
  file_bytes_ = 0;
}

// What the disk has not taken by now is lost with the old record.
void RemoteRecorder::BeginRecord() {
  Write();
  Report(series_->Sync());
  pending_.clear();
  try {
    series_ = std::make_unique<RecordSeries>(PathOfRun(path_, ++records_), options_.keep_files);
  } catch (const std::runtime_error& error) {
    Report(Problem{error.what()});
    Report(series_->Next());
  }
  file_bytes_ = 0;
  has_frames_ = false;
  has_ended_ = false;
}

void RemoteRecorder::Note(const std::string& text) {
  if (!has_frames_) return;
  Append(MakeFrame(FrameType::kNote, EncodeNote, HistoryNote{time_, "connection", text}));
  Write();
}

void RemoteRecorder::Append(const Bytes& bytes) {
  pending_.insert(pending_.end(), bytes.begin(), bytes.end());
  file_bytes_ += bytes.size();
  has_frames_ = true;
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.bytes += bytes.size();
}

// What the kernel does not take now is tried again with the next frame.
void RemoteRecorder::Write() {
  if (!pending_.empty()) Report(series_->Write(pending_));
  const auto now = std::chrono::steady_clock::now();
  if (now - synced_ < kSyncPeriod) return;
  synced_ = now;
  Report(series_->Sync());
}

void RemoteRecorder::Report(const Outcome& outcome) {
  if (outcome) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  error_ = outcome.problem();
}

}  // namespace coppice
