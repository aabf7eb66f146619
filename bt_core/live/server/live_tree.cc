#include "bt_core/live/server/live_tree.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "bt_core/data/literal.h"
#include "bt_core/engine/events/for_each_event.h"
#include "bt_core/frames/pause_note.h"

namespace coppice {
namespace {

constexpr std::size_t kMaxWaiting = 4096;  // notices of replaced results

// What is kept is thrown away from state to state, so there must be some.
HistoryOptions OptionsOfHistory(const RunInfo& info, std::size_t kept_bytes) {
  constexpr std::size_t kStatesKept = 8;
  HistoryOptions options;
  options.info = info;
  options.keyframe_bytes = std::min(options.keyframe_bytes, kept_bytes / kStatesKept);
  return options;
}

RunInfo Begin(const Clock& clock, const RunId& run) {
  RunInfo info = BeginRun(clock);
  if (run != RunId()) info.run = run;
  return info;
}

// The type that JSON says; null: none that scripts know.
const Type* TypeOfJson(const std::string& json) {
  const char first = json.empty() ? '\0' : json[0];
  if (first == '"') return &TypeOf<std::string>();
  if (first == 't' || first == 'f') return &TypeOf<bool>();
  if (first != '-' && (first < '0' || first > '9')) return nullptr;
  const bool is_whole = json.find_first_of(".eE") == std::string::npos;
  return is_whole ? &TypeOf<std::int64_t>() : &TypeOf<double>();
}

// A key that only scripts use has no type before it has a value.
Expected<Value> ReadValue(const SlotDefinition& slot, const std::string& text, bool is_text) {
  const Type* type = slot.type ? slot.type : slot.initial.type();
  if (!type && is_text) return GuessValue(text);
  if (!type) type = TypeOfJson(text);
  if (!type) {
    return Problem{"no node says which type it has: a number, a text, true or false is expected"};
  }
  try {
    Value value;
    if (is_text ? value.Parse(*type, text) : value.FromJson(*type, text)) return value;
  } catch (const std::exception& error) {  // from the conversion of a type of the application
    return Problem{std::string("this is no ") + type->name + ": " + error.what()};
  }
  return Problem{text.substr(0, 200) + " is no " + type->name};
}

SlotIndex FindSlot(const Layout& layout, const std::string& scope, const std::string& key) {
  for (ScopeIndex i{0}; i < layout.scopes.size(); ++i) {
    if (layout.scopes[i] == scope || (i == 0 && scope.empty())) return layout.Find(i, key);
  }
  return kNoSlot;
}

}  // namespace

LiveTree::LiveTree(EventStream& stream, LiveTreeOptions options, std::function<void()> wake)
    : options_(std::move(options)),
      wake_(std::move(wake)),
      stream_(stream),
      clock_(stream.executor().clock()),
      executor_(stream.executor()),
      inbox_(stream.executor().inbox()),
      run_(Begin(clock_, options_.run)),
      frames_(options_.history_bytes),
      encoder_(OptionsOfHistory(run_, options_.history_bytes), *this),
      debugger_(stream.executor(), {[this] { return Permission(); },
                                    [this](const DebugEvent& event) { OnDebugEvent(event); }}) {}

Outcome LiveTree::Permission() const {
  if (options_.read_only) return Problem{"this robot can be watched, not controlled (read-only)"};
  try {
    return options_.permission ? options_.permission() : Outcome();
  } catch (const std::exception& error) {  // it should not; but the tree must not suffer from it
    return Problem{std::string("it is not known whether this is allowed now: ") + error.what()};
  }
}

void LiveTree::OnState(const StreamState& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  encoder_.Add(state);
  lost_ticks_ += state.lost_ticks;
  if (state.program != program_) SetProgram(state.program);
  if (transitions_.is_recording()) {
    transitions_.Jump(StatusFollower(ShapeOf(*program_), state.statuses));
  }
  wake_();
}

void LiveTree::SetProgram(std::shared_ptr<const Program> program) {
  if (program_) {
    id_ = groot2::RandomTreeId();
    program_changed_ = true;
  }
  program_ = std::move(program);
  counts_.assign(program_->nodes.size(), {});
}

void LiveTree::OnTick(const TickEvents& events) {
  const std::lock_guard<std::mutex> lock(mutex_);
  encoder_.Add(events);
  transitions_.Add(events);
  Count(events);
  if (subscribers_ > 0) wake_();
}

void LiveTree::Count(const TickEvents& events) {
  const auto count = [counts = counts_.data(), size = counts_.size()](NodeIndex node,
                                                                      Status status) {
    if (status == Status::kIdle || node >= size) return;
    ++counts[node][static_cast<std::size_t>(status) - 1];
  };
  ForEachEvent(events.words, count, [](const Event&) {});
}

void LiveTree::OnFrame(const Frame& frame) {
  frames_.Add({frame.type, frame.tick, frame.time,
               std::string(reinterpret_cast<const char*>(frame.data), frame.size)});
}

LiveTreeInfo LiveTree::Info() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  LiveTreeInfo info;
  info.name = options_.name.empty() ? program_->trees[0].id : options_.name;
  info.run = run_.run;
  info.nodes = program_->nodes.size();
  info.tick = encoder_.follower()->tick();
  info.first_frame = frames_.first();
  info.next_frame = frames_.next();
  info.lost_ticks = lost_ticks_;
  info.recording_dropped = transitions_.dropped();
  return info;
}

std::shared_ptr<const Program> LiveTree::program() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return program_;
}

groot2::TreeId LiveTree::id() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return id_;
}

OfProgram<std::uint8_t> LiveTree::ShownStatuses() const {
  constexpr std::uint8_t kWasReset = 10;
  const std::lock_guard<std::mutex> lock(mutex_);
  const HistoryFollower& tree = *encoder_.follower();
  std::vector<std::uint8_t> shown;
  shown.reserve(program_->nodes.size());
  for (NodeIndex node{0}; node < program_->nodes.size(); ++node) {
    const bool was_reset = tree.status(node) == Status::kIdle && tree.last(node) != Status::kIdle;
    const Status status = was_reset ? tree.last(node) : tree.status(node);
    shown.push_back(
        static_cast<std::uint8_t>(static_cast<std::uint8_t>(status) + (was_reset ? kWasReset : 0)));
  }
  return {program_, std::move(shown)};
}

OfProgram<std::string> LiveTree::Values() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {program_, encoder_.follower()->values()};
}

OfProgram<ResultCounts> LiveTree::Counts() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {program_, counts_};
}

std::uint64_t LiveTree::StartRecording() {
  const auto wall = std::chrono::system_clock::now().time_since_epoch();
  const std::lock_guard<std::mutex> lock(mutex_);
  transitions_.Start(StatusFollower(ShapeOf(*program_), encoder_.follower()->statuses()),
                     clock_.Now());
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(wall).count());
}

void LiveTree::StopRecording() {
  const std::lock_guard<std::mutex> lock(mutex_);
  transitions_.Stop();
}

std::string LiveTree::TakeTransitions() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return transitions_.Take();
}

Outcome LiveTree::Write(const std::string& scope, const std::string& key, const std::string& value,
                        bool is_text) {
  const std::shared_ptr<const Program> tree = program();
  const SlotIndex slot = FindSlot(tree->layout, scope, key);
  if (slot == kNoSlot) {
    return Problem{"\"" + scope + "\" has no key \"" + key +
                   "\" of its own; see where it is remapped from"};
  }
  Expected<Value> parsed = ReadValue(tree->layout.slots[slot], value, is_text);
  if (!parsed) return Problem{"key \"" + key + "\": " + parsed.problem()};
  inbox_->PostCall([tree, slot, parsed = *std::move(parsed), &executor = executor_] {
    if (&executor.program() == tree.get()) executor.inbox()->Post(slot, 0, parsed);
  });
  inbox_->RequestTick();
  return {};
}

void LiveTree::EndHistory() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (std::exchange(ended_, true)) return;
  encoder_.End(HistoryEnd::Cause::kClosed, clock_.Now());
}

// The ticking thread. Who hears of a stop and asks how the tree stands sees it as it stands there;
// it waits anyway.
void LiveTree::OnDebugEvent(const DebugEvent& event) {
  if (event.kind == DebugEvent::Kind::kStopped) {
    stream_.Flush();
    stopped_ = {clock_.Now(), std::chrono::steady_clock::now(), event.stop};
  }
  if (event.kind == DebugEvent::Kind::kResumed) NotePause();
  {
    const std::lock_guard<std::mutex> lock(debug_mutex_);
    if (event.kind == DebugEvent::Kind::kReplaced && debug_events_.size() >= kMaxWaiting) return;
    debug_events_.push_back(event);
  }
  wake_();
}

void LiveTree::NotePause() {
  Pause pause{stopped_.at, std::max(stopped_.at, clock_.Now())};
  if (stopped_.where.where != DebugStop::Where::kBetweenTicks) {
    pause.tick = stopped_.where.tick;
    pause.of_tick = std::chrono::steady_clock::now() - stopped_.real;
  }
  const HistoryNote note = NoteOf(pause);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!ended_) encoder_.Note(note);
  }
  if (options_.on_note) options_.on_note(note);
}

std::vector<DebugEvent> LiveTree::TakeDebugEvents() {
  const std::lock_guard<std::mutex> lock(debug_mutex_);
  return std::exchange(debug_events_, {});
}

}  // namespace coppice
