#include "editor/live/record_source.h"

#include <algorithm>
#include <utility>

#include "bt_core/analysis/formats/import_btlog.h"
#include "bt_core/base/read_file.h"

namespace coppice::editor {
namespace {

constexpr std::size_t kWordsPerPump = 200000;  // a few milliseconds

bool EndsIn(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::optional<Recording> ReadLog(const std::string& path, Diagnostics& diagnostics) {
  const std::optional<std::string> bytes = ReadFile(path, diagnostics, kLongestBtlog);
  return bytes ? FromBtlog(*bytes, path, diagnostics) : std::nullopt;
}

}  // namespace

bool IsRecordName(const std::string& path) {
  return EndsIn(path, ".coppice") || EndsIn(path, ".btlog");
}

std::unique_ptr<RecordSource> RecordSource::Open(const std::string& path,
                                                 Diagnostics& diagnostics) {
  std::unique_ptr<RecordSource> source(new RecordSource(path));
  if (EndsIn(path, ".btlog")) {
    source->log_ = ReadLog(path, diagnostics);
    if (!source->log_) return nullptr;
    return source;
  }
  source->record_ = RecordReader::Open(path, diagnostics);
  if (!source->record_) return nullptr;
  source->cursor_.emplace(*source->record_);
  return source;
}

double RecordSource::progress() const {
  if (is_done_ || !cursor_) return is_done_ ? 1 : 0;
  const std::uint64_t first = record_->first_tick();
  const std::uint64_t all = std::max<std::uint64_t>(record_->last_tick() - first, 1);
  const std::uint64_t done = std::min(std::max(cursor_->state().tick(), first) - first, all);
  return static_cast<double>(done) / static_cast<double>(all);
}

std::size_t RecordSource::most_bytes() const {
  return record_ ? MostRunBytes(*record_) : kMostRunBytes;
}

void RecordSource::Send(LiveCommand, LiveClient::ReplyHandler on_reply) {
  if (on_reply) on_reply(Problem{"this is a record: nothing can be changed in it"});
}

void RecordSource::Pump(LiveListener& listener) {
  if (!has_begun_) Begin(listener);
  if (log_) {
    Tell(*log_, listener);
    log_.reset();
    is_done_ = true;
  }
  for (std::size_t words = 0; !is_done_ && words < kWordsPerPump;) {
    const RecordItem item = cursor_->Next();
    is_done_ = !Take(item, listener);
    words += 16 + (item == RecordItem::kTick ? cursor_->events().words.size : 0);
  }
  was_done_ = was_done_ || is_done_;
}

void RecordSource::Begin(LiveListener& listener) {
  has_begun_ = true;
  if (!cursor_) return;
  tree_ = &cursor_->tree();
  listener.OnTree(*tree_);
  listener.OnState(cursor_->state().State(HistoryState::Cause::kBegin));
}

void RecordSource::Refresh() {
  if (!is_cut_ && may_grow() && is_done_ && record_->Refresh()) is_done_ = false;
}

bool RecordSource::Take(RecordItem item, LiveListener& listener) {
  switch (item) {
    case RecordItem::kTick:
      TakeTick(cursor_->events(), listener);
      break;
    case RecordItem::kTree:
      if (&cursor_->tree() != tree_) listener.OnTree(cursor_->tree());
      tree_ = &cursor_->tree();
      break;
    case RecordItem::kState:
      listener.OnState(cursor_->state().State(is_lost_ ? HistoryState::Cause::kLost
                                                       : HistoryState::Cause::kJump));
      is_lost_ = false;
      break;
    case RecordItem::kGap:
      is_lost_ = true;
      listener.OnGap(cursor_->gap());
      break;
    case RecordItem::kDamage:
      is_lost_ = true;
      break;
    case RecordItem::kNote:
      listener.OnNote(cursor_->note());
      break;
    case RecordItem::kEnd:
      has_ended_ = true;
      listener.OnEnd(cursor_->end());
      break;
    case RecordItem::kNone:
      return false;
  }
  return true;
}

// Parts of a tick bring what was before: only the rest is new.
void RecordSource::TakeTick(TickEvents events, LiveListener& listener) {
  const std::size_t known = events.tick == part_of_ ? known_words_ : 0;
  known_words_ = events.words.size;
  part_of_ = events.is_whole ? 0 : events.tick;
  events.words.data += known;
  events.words.size -= known;
  listener.OnTick(events);
}

void Tell(const Recording& run, HistoryHandler& handler) {
  std::size_t told_trees = 0;
  std::size_t section = 0;
  const auto tell_sections = [&](std::size_t tick) {
    for (; section < run.sections().size() && run.sections()[section].first_tick <= tick;
         ++section) {
      const Recording::Section& next = run.sections()[section];
      for (; told_trees <= next.tree; ++told_trees) handler.OnTree(run.trees()[told_trees]);
      handler.OnState(next.state);
    }
  };
  for (std::size_t tick = 0; tick < run.ticks().size(); ++tick) {
    tell_sections(tick);
    handler.OnTick(run.EventsOf(tick));
  }
  tell_sections(run.ticks().size());
}

}  // namespace coppice::editor
