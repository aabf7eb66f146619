#include "bt_core/record/recorder.h"

#include <algorithm>
#include <utility>

#include "bt_core/record/entry_coding.h"
#include "bt_core/history/frame.h"
#include "bt_core/record/record_writer.h"

namespace coppice {
namespace {

constexpr std::size_t kFirstFrameBytes = 64 << 10;  // grows if a tick needs more

Bytes StartOfRecord(Executor& executor, const Metadata& metadata) {
  Bytes start;
  AppendPreamble(start);
  const std::size_t frame = OpenFrame(start, FrameType::kHeader);
  Encoder encoder(start);
  EncodeHeader(executor, metadata, encoder);
  CloseFrame(start, frame);
  SealFrame(start.data() + frame);
  return start;
}

bool NothingHappened(const TickEvents& events) {
  return events.changes.empty() && events.writes.empty() && events.messages.empty();
}

}  // namespace

Recorder::Recorder(Executor& executor, const std::string& path, const RecorderOptions& options)
    : executor_(executor),
      writer_(std::make_unique<RecordWriter>(
          path, StartOfRecord(executor, options.metadata), options.buffer_bytes,
          RecordWriter::Periods{options.flush_period, options.sync_period})) {
  frames_.reserve(kFirstFrameBytes);
  executor_.AddSink(this);
}

Recorder::~Recorder() { Close(); }

void Recorder::OnTick(const TickEvents& events) {
  if (NothingHappened(events)) return;
  if (!PushTick(events)) CountLost(events.tick);
}

bool Recorder::PushTick(const TickEvents& events) {
  if (writer_->room() < needed_room_) return false;
  frames_.clear();
  gap_.lost_notes = writer_->lost_notes();
  if (gap_.lost_ticks > 0 || gap_.lost_notes > 0) AppendGap(events.start);
  const std::size_t frame = OpenFrame(frames_, FrameType::kTick);
  Encoder encoder(frames_);
  EncodeTick(events, encoder);
  CloseFrame(frames_, frame);
  if (!writer_->Push(frames_)) {
    needed_room_ = std::min(frames_.size(), writer_->capacity());
    return false;
  }
  needed_room_ = 0;
  writer_->ForgetLostNotes(gap_.lost_notes);
  gap_ = RecordedGap();
  return true;
}

void Recorder::AppendGap(Time time) {
  gap_.time = time;
  const std::size_t frame = OpenFrame(frames_, FrameType::kGap);
  Encoder encoder(frames_);
  EncodeGap(gap_, executor_.statuses(), executor_.blackboard(), encoder);
  CloseFrame(frames_, frame);
}

void Recorder::CountLost(std::uint64_t tick) {
  if (gap_.lost_ticks == 0) gap_.first_tick = tick;
  ++gap_.lost_ticks;
  gap_.last_tick = tick;
  lost_ticks_.fetch_add(1, std::memory_order_relaxed);
}

void Recorder::Note(Time time, std::string kind, std::string text) {
  writer_->PushNote({time, std::move(kind), std::move(text)});
}

std::string Recorder::Close() {
  if (closed_) return error();
  closed_ = true;
  executor_.RemoveSink(this);
  const Time now = executor_.clock().Now();
  frames_.clear();
  gap_.lost_notes = writer_->lost_notes();
  if (gap_.lost_ticks > 0 || gap_.lost_notes > 0) AppendGap(now);
  const std::size_t frame = OpenFrame(frames_, FrameType::kEnd);
  Encoder encoder(frames_);
  EncodeEnd({now, executor_.ticks()}, encoder);
  CloseFrame(frames_, frame);
  writer_->Stop(frames_);
  if (error().empty() && lost_ticks() > 0) {
    return std::to_string(lost_ticks()) + " ticks are missing: the disk was too slow";
  }
  return error();
}

std::uint64_t Recorder::flushed_tick() const { return writer_->flushed_tick(); }

std::string Recorder::error() const { return writer_->error(); }

}  // namespace coppice
