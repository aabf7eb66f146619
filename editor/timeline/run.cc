#include "editor/timeline/run.h"

#include <algorithm>
#include <utility>

#include "bt_core/frames/history_size.h"
#include "bt_core/frames/pause_note.h"

namespace coppice::editor {
namespace {

constexpr Duration kRestart = std::chrono::seconds(1);  // on the axis
constexpr std::size_t kFewestKeyframeWords = 16 << 10;  // between two states that are kept
constexpr std::size_t kKeyframeWordsPerEntry = 16;      // for each node and slot of a state
constexpr std::size_t kCopiesOfTree = 4;   // in the recording, its tracks, and what is drawn of it
constexpr std::size_t kBytesPerWord = 12;  // in the recording, and in the tracks
constexpr std::size_t kRoom = 2;           // of what grows, as much again is free

// The last element whose tick is at or before `tick`; there is one.
template <class Elements>
const auto& LastAt(const Elements& elements, std::size_t tick) {
  const auto behind = std::upper_bound(elements.begin() + 1, elements.end(), tick,
                                       [](std::size_t t, const auto& e) { return t < e.tick; });
  return *(behind - 1);
}

}  // namespace

const Tracks& Run::TracksAt(std::size_t tick) const { return *LastAt(tracks_, tick).tracks; }

bool Run::is_at_beginning() const {
  const auto& sections = recording_.sections();
  return !sections.empty() && sections.back().first_tick == size() &&
         sections.back().state.cause == HistoryState::Cause::kBegin;
}

Time Run::TimeOf(std::size_t tick) const {
  return recording_.ticks()[tick].start + LastAt(epochs_, tick).offset;
}

std::size_t Run::TickAt(Time time) const {
  std::size_t first = 0;
  std::size_t count = size();
  while (count > 0) {
    const std::size_t half = count / 2;
    if (TimeOf(first + half) <= time) {
      first += half + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
  return first == 0 ? 0 : first - 1;
}

std::size_t Run::Activity(std::size_t first, std::size_t end) const {
  const auto& ticks = recording_.ticks();
  end = std::min(end, ticks.size());
  if (first >= end) return 0;
  return ticks[end - 1].first_word + ticks[end - 1].words - ticks[first].first_word;
}

Event Run::EventAt(const SlotWrite& write) const {
  EventWords words = recording_.EventsOf(write.tick).words;
  words.data += write.word;
  words.size -= write.word;
  Event event;
  EventReader(words).Next(event);
  return event;
}

const Recording::Section& Run::SectionAt(std::size_t tick) const {
  const auto& sections = recording_.sections();
  const auto behind = std::upper_bound(
      sections.begin() + 1, sections.end(), tick,
      [](std::size_t t, const Recording::Section& section) { return t < section.first_tick; });
  return *(behind - 1);
}

void Run::OnTree(const TreeDescription& tree) {
  bytes_ += kCopiesOfTree * BytesOf(tree);
  const auto& trees = recording_.trees();
  other_run_ = other_run_ || (!trees.empty() && trees.back().info.run != tree.info.run);
  recording_.OnTree(tree);
  auto shared = std::make_shared<const TreeDescription>(tree);
  if (!tracks_.empty() && tracks_.back().tracks->GoOnAs(shared)) return;
  other_tree_ = !tracks_.empty();
  tracks_.push_back({size(), std::make_shared<Tracks>(std::move(shared))});
}

void Run::OnState(const HistoryState& state) {
  if (tracks_.empty()) return;
  Keep(state);
  if (state.cause != HistoryState::Cause::kKeyframe || !follower_) Begin(state);
}

// Keyframes take no more than the events between them.
void Run::Keep(const HistoryState& state) {
  recording_.OnState(state);
  const std::size_t bytes = BytesOf(state);
  bytes_ += bytes;
  const TreeDescription& tree = *tracks_.back().tracks->tree();
  keyframe_every_ = std::max({kFewestKeyframeWords, bytes / sizeof(std::uint32_t),
                              kKeyframeWordsPerEntry * (tree.nodes.size() + tree.slots.size())});
}

void Run::Begin(const HistoryState& state) {
  Tracks& tracks = *tracks_.back().tracks;
  const bool goes_on = !other_run_ && !other_tree_ && lost_ticks_ == 0 && follower_ &&
                       follower_->statuses() == state.statuses;
  if (follower_ && !goes_on) {
    breaks_.push_back({size(), state.cause, lost_ticks_, other_run_, other_tree_});
  }
  follower_.emplace(tracks.shape(), state);
  tracks.Begin(size(), state);
  since_keyframe_ = 0;
  lost_ticks_ = 0;
}

void Run::OnTick(const TickEvents& events) {
  if (!follower_) return;
  const std::size_t before = size();
  bytes_ += kRoom * (sizeof(Recording::Tick) + kBytesPerWord * events.words.size);
  recording_.OnTick(events);
  const std::size_t tick = size() - 1;
  const Duration stood = stood_.tick == events.tick ? stood_.time : Duration(0);
  const float milliseconds = static_cast<float>((events.duration - stood).count()) * 1e-6F;
  if (size() == before) {
    durations_.RaiseLast(milliseconds);
  } else {
    durations_.Add(milliseconds);
    KeepTime(tick);
  }
  const std::size_t word = recording_.ticks()[tick].words - events.words.size;
  tracks_.back().tracks->Add(tick, word, events, *follower_);
  since_keyframe_ += events.words.size;
  if (events.is_whole && since_keyframe_ >= keyframe_every_) AddKeyframe();
}

void Run::AddKeyframe() {
  Keep(follower_->State(HistoryState::Cause::kKeyframe));
  since_keyframe_ = 0;
}

// The axis begins at 0 and never goes back, whatever the robot's clock does.
void Run::KeepTime(std::size_t tick) {
  const Time start = recording_.ticks()[tick].start;
  if (tick == 0) {
    epochs_.push_back({0, Time{} - start});
  } else {
    const Time last = TimeOf(tick - 1);
    const bool goes_back = start + epochs_.back().offset < last;
    if (other_run_) epochs_.push_back({tick, last + kRestart - start});
    if (!other_run_ && goes_back) epochs_.push_back({tick, last - start});
  }
  other_run_ = other_tree_ = false;
}

void Run::OnNote(const HistoryNote& note) {
  bytes_ += BytesOf(note);
  recording_.OnNote(note);
  const std::optional<Pause> pause = PauseOf(note);
  if (!pause || pause->tick == 0) return;
  if (pause->tick != stood_.tick) stood_ = {pause->tick};
  stood_.time += pause->of_tick;
}

void Run::OnGap(const HistoryGap& gap) {
  bytes_ += sizeof(gap);
  recording_.OnGap(gap);
  lost_ticks_ += gap.lost_ticks;
}

void RunPlace::Go(std::size_t tick) {
  const Recording::Section& section = run_.SectionAt(tick);
  std::size_t next = tick_ + 1;
  const bool goes_on = state_ && tick >= tick_ && section.first_tick <= tick_ &&
                       run_.recording().ticks()[tick_].is_whole;
  if (!goes_on) {
    state_.emplace(run_.TracksAt(tick).shape(), section.state);
    next = section.first_tick;
  }
  for (; next <= tick; ++next) state_->Apply(run_.recording().EventsOf(next));
  tick_ = tick;
}

}  // namespace coppice::editor
