#include "bt_core/record/recorder.h"

#include <utility>

#include "bt_core/record/record_writer.h"

namespace coppice {
namespace {

HistoryOptions OptionsOf(Executor& executor, const RecorderOptions& options) {
  HistoryOptions history;
  history.info = BeginRun(executor.clock());
  history.info.metadata = options.metadata;
  if (options.run != RunId()) history.info.run = options.run;
  if (!options.clock.empty()) history.info.clock = options.clock;
  return history;
}

}  // namespace

Recorder::Recorder(EventStream& stream, const std::string& path, const RecorderOptions& options)
    : stream_(stream),
      writer_(
          std::make_unique<RecordWriter>(path, options, OptionsOf(stream.executor(), options))) {
  stream_.Add(*this);
  stream_.Flush();  // now it knows the tree: a note may follow
}

Recorder::~Recorder() { static_cast<void>(Close()); }

void Recorder::OnState(const StreamState& state) { writer_->Add(state); }

void Recorder::OnTick(const TickEvents& events) { writer_->Add(events); }

void Recorder::Note(Time time, std::string kind, std::string text) {
  writer_->Add({time, std::move(kind), std::move(text)});
}

Outcome Recorder::Close() {
  if (!closed_) {
    closed_ = true;
    stream_.Remove(*this);
    writer_->Stop(stream_.executor().clock().Now());
  }
  if (const std::string text = error(); !text.empty()) return Problem{text};
  if (lost_ticks() == 0) return {};
  return Problem{std::to_string(lost_ticks()) +
                 " ticks are missing: disk or computer was too slow"};
}

std::uint64_t Recorder::lost_ticks() const { return writer_->lost_ticks(); }

std::uint64_t Recorder::flushed_tick() const { return writer_->flushed_tick(); }

std::string Recorder::error() const { return writer_->error(); }

std::string Recorder::trouble() const { return writer_->trouble(); }

}  // namespace coppice
