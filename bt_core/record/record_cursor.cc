#include "bt_core/record/record_cursor.h"

#include <algorithm>
#include <utility>

namespace coppice {

namespace {

// How a tree stands when nothing is known of it but the place.
HistoryState UnknownState(const TreeSize& size, const RecordKeyframe& place) {
  HistoryState state;
  state.tick = place.tick;
  state.time = place.time;
  state.statuses.resize(size.nodes, Status::kIdle);
  state.last = state.statuses;
  state.values.resize(size.slots);
  return state;
}

}  // namespace

// What the frames that were read last bring, in order.
class RecordCursor::Items final : public HistoryHandler {
 public:
  struct Item {
    RecordItem kind;
    TickEvents events;  // of a tick; its words lie in `words_`
    std::size_t words;
  };

  bool empty() const { return next_ == items_.size(); }
  const Item& front() const { return items_[next_]; }
  void Pop() { ++next_; }
  EventWords WordsOf(const Item& item) const {
    return {words_.data() + item.words, item.events.words.size};
  }
  void Clear() {
    items_.clear();
    words_.clear();
    next_ = 0;
  }

  void Add(RecordItem kind) { items_.push_back({kind, {}, 0}); }

  void OnTree(const TreeDescription&) override {}
  void OnState(const HistoryState& s) override { state = s; }
  void OnTick(const TickEvents& events) override {
    items_.push_back({RecordItem::kTick, events, words_.size()});
    words_.insert(words_.end(), events.words.data, events.words.data + events.words.size);
  }
  void OnGap(const HistoryGap& g) override {
    gap = g;
    Add(RecordItem::kGap);
  }
  void OnNote(const HistoryNote& n) override {
    note = n;
    Add(RecordItem::kNote);
  }
  void OnEnd(const HistoryEnd& e) override {
    end = e;
    if (e.cause == HistoryEnd::Cause::kClosed) Add(RecordItem::kEnd);
  }

  std::optional<HistoryState> state;
  HistoryGap gap;
  HistoryNote note;
  HistoryEnd end;

 private:
  std::vector<Item> items_;
  std::vector<std::uint32_t> words_;
  std::size_t next_ = 0;
};

RecordCursor::RecordCursor(const RecordReader& record)
    : record_(record), items_(std::make_unique<Items>()) {
  SeekBegin();
}

RecordCursor::~RecordCursor() = default;

void RecordCursor::SeekBegin() { GoTo(record_.keyframes().front()); }

void RecordCursor::SeekLast() {
  GoTo(record_.keyframes().back());
  while (Next() != RecordItem::kNone) {
  }
}

void RecordCursor::SeekTick(std::uint64_t tick) {
  GoTo(LastKeyframe([&](const RecordKeyframe& keyframe) { return keyframe.tick < tick; }));
  Seek(
      [&](std::uint64_t number, Time, bool is_tick) {
        return number > tick || (number == tick && !is_tick && state_->tick() >= tick);
      },
      [&] { return events_.tick == tick && events_.is_whole && events_.result != Status::kIdle; });
}

void RecordCursor::SeekTime(Time time) {
  GoTo(LastKeyframe([&](const RecordKeyframe& keyframe) { return keyframe.time < time; }));
  Seek([&](std::uint64_t, Time start, bool) { return start > time; }, [] { return false; });
}

// The last one in the record for which that is true; else the first.
template <class IsBefore>
const RecordKeyframe& RecordCursor::LastKeyframe(IsBefore is_before) const {
  const auto& all = record_.keyframes();
  const auto found = std::find_if(all.rbegin(), all.rend(), is_before);
  return found == all.rend() ? all.front() : *found;
}

// Goes on until what comes next lies behind the place, or the place is reached.
template <class IsBehind, class IsThere>
void RecordCursor::Seek(IsBehind is_behind, IsThere is_there) {
  while (!items_->empty() || Load()) {
    const Items::Item& next = items_->front();
    if (next.kind == RecordItem::kTick) {
      const bool is_tick = !next.events.is_whole || next.events.result != Status::kIdle;
      if (is_behind(next.events.tick, next.events.start, is_tick)) return;
      Take();
      if (is_there()) return;
    } else {
      const bool has_state = next.kind == RecordItem::kState || next.kind == RecordItem::kTree;
      if (has_state && is_behind(items_->state->tick, items_->state->time, true)) return;
      Take();
    }
  }
}

RecordItem RecordCursor::Next() {
  if (items_->empty() && !Load()) return RecordItem::kNone;
  return Take();
}

const TreeDescription& RecordCursor::tree() const { return record_.trees()[tree_]; }

const HistoryGap& RecordCursor::gap() const { return items_->gap; }
const HistoryNote& RecordCursor::note() const { return items_->note; }
const HistoryEnd& RecordCursor::end() const { return items_->end; }

void RecordCursor::GoTo(const RecordKeyframe& keyframe) {
  damages_.clear();
  items_->Clear();
  if (!file_ || file_number_ != keyframe.file) OpenFile(keyframe.file);
  offset_ = keyframe.offset;
  tree_ = keyframe.tree;
  next_tree_ = tree_;
  decoder_.SetTree(SizeOf(tree()));
  shows_state_ = true;
  state_.emplace(ShapeOf(tree()), UnknownState(SizeOf(tree()), keyframe));
  if (Load()) Take();
}

TreeSize RecordCursor::SizeOf(const TreeDescription& tree) {
  return {tree.nodes.size(), tree.slots.size()};
}

void RecordCursor::OpenFile(std::uint32_t number) {
  file_number_ = number;
  file_ = std::make_unique<FrameFile>(record_.files()[number]);
  offset_ = kPreambleSize;
}

// Reads frames until one brings something. False at the end of what the record knows.
bool RecordCursor::Load() {
  items_->Clear();
  while (items_->empty()) {
    const std::uint64_t end = record_.SizeOf(file_number_);
    if (file_->size() < end) file_->Refresh();
    const FrameFile::Span span = file_->Hop(offset_);
    if (span.size == 0 || span.offset + span.size > end) {
      if (file_number_ + 1 == record_.files().size()) return false;
      if (span.damaged > 0) AddDamage(offset_, span.damaged);
      OpenFile(file_number_ + 1);
      continue;
    }
    if (span.damaged > 0) AddDamage(span.offset - span.damaged, span.damaged);
    Read(span);
  }
  return true;
}

void RecordCursor::Read(const FrameFile::Span& span) {
  offset_ = span.offset + span.size;
  const auto type = static_cast<FrameType>(span.type);
  if (type == FrameType::kEvents && !decoder_.follows()) return;  // belongs to a damage before
  if (type == FrameType::kTree) return ReadTree(span);
  items_->state.reset();
  const std::uint8_t* const frame = file_->View(span.offset, span.size);
  if (!frame || !decoder_.Decode(frame, span.size, *items_)) {
    const FrameFile::Span next = file_->Find(span.offset + 1);
    offset_ = next.offset;
    return AddDamage(span.offset, next.offset - span.offset);
  }
  if (items_->state) ShowState();
}

// The record knows the trees already.
void RecordCursor::ReadTree(const FrameFile::Span& span) {
  const std::uint32_t tree = record_.TreeAt(file_number_, span.offset);
  if (tree == RecordReader::kNoTree) return AddDamage(span.offset, span.size);
  next_tree_ = tree;
  decoder_.SetTree(SizeOf(record_.trees()[tree]));
}

// A state that only repeats what is known is not shown.
void RecordCursor::ShowState() {
  if (next_tree_ != tree_) {
    items_->Add(RecordItem::kTree);
  } else if (shows_state_ || items_->state->cause != HistoryState::Cause::kKeyframe) {
    items_->Add(RecordItem::kState);
  }
  shows_state_ = false;
}

void RecordCursor::AddDamage(std::uint64_t offset, std::uint64_t bytes) {
  decoder_.Forget();
  shows_state_ = true;
  damages_.push_back({file_number_, offset, std::to_string(bytes) + " bytes are damaged"});
  items_->Add(RecordItem::kDamage);
}

RecordItem RecordCursor::Take() {
  const RecordItem kind = items_->front().kind;
  if (kind == RecordItem::kTick) {
    TakeTick();
  } else if (kind == RecordItem::kState || kind == RecordItem::kTree) {
    tree_ = next_tree_;
    state_.emplace(ShapeOf(tree()), *items_->state);
    events_ = TickEvents();
  }
  items_->Pop();
  return kind;
}

void RecordCursor::TakeTick() {
  TickEvents part = items_->front().events;
  part.words = items_->WordsOf(items_->front());
  state_->Apply(part);
  const bool goes_on = !events_.is_whole && events_.tick == part.tick;
  events_ = part;
  if (!goes_on) words_.clear();
  if (!goes_on && part.is_whole) return;
  words_.insert(words_.end(), part.words.data, part.words.data + part.words.size);
  events_.words = {words_.data(), words_.size()};
}

}  // namespace coppice
