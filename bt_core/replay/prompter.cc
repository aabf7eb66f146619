#include "bt_core/replay/prompter.h"

#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

bool IsWrite(const Event& event) {
  return event.code == EventCode::kWrite || event.code == EventCode::kDelivery;
}

// A type that is known only here or only there has another form with the same content.
bool IsSameValue(std::string_view a, std::string_view b) {
  return a == b || ValueBytesToJson(a) == ValueBytesToJson(b);
}

bool IsSame(const Event& a, const Event& b) {
  if (a.code != b.code || a.index != b.index) return false;
  if (a.is_status()) return true;
  if (IsWrite(a)) return a.writer == b.writer && IsSameValue(a.bytes, b.bytes);
  return a.text == b.text && a.bytes == b.bytes;
}

bool ChangesNothing(const StatusFollower& statuses, const Event& event) {
  return event.code == EventCode::kReset && statuses.status(event.index) == Status::kIdle;
}

bool IsInjected(const Event& event, NodeIndex node) {
  return event.code == EventCode::kText && event.text == EventText::kInjected &&
         event.index == node && event.bytes.size() == 1;
}

}  // namespace

bool HasDrainedIn(const Event* begin, const Event* end, NodeIndex node) {
  bool was_reset = false;
  for (const Event* event = begin; event != end; ++event) {
    if (!event->is_status()) continue;
    if (!was_reset && event->is_result()) return false;
    if (event->index != node) continue;
    if (event->is_result()) return was_reset;
    was_reset = true;
  }
  return false;
}

void Prompter::Begin(const RecordedTree& tree, const std::vector<Status>& statuses) {
  tree_ = &tree;
  expected_statuses_.emplace(tree.shape, statuses);
  actual_statuses_.emplace(tree.shape, statuses);
  expected_.clear();
  at_ = 0;
}

// Writes of slots that the program does not have, such as mailboxes, cannot be repeated.
bool Prompter::IsPlayed(const Event& event) const {
  return !IsWrite(event) || tree_->program_slots[event.index] != kNoSlot;
}

void Prompter::Expect(const TickEvents& events) {
  played_ = events;
  expected_.clear();
  at_ = 0;
  EventReader reader(events.words);
  for (Event event; reader.Next(event);) {
    if (!IsPlayed(event)) continue;
    if (IsWrite(event)) event.index = tree_->program_slots[event.index];
    expected_.push_back(event);
  }
  SkipWhatChangesNothing();
}

void Prompter::SkipWhatChangesNothing() {
  while (at_ < expected_.size() && ChangesNothing(*expected_statuses_, expected_[at_])) ++at_;
}

bool Prompter::Sync() {
  if (!divergence_) executor_->ReportSoFar();
  return !divergence_;
}

void Prompter::OnTick(const TickEvents& events) {
  EventReader reader(events.words);
  for (Event event; reader.Next(event);) Compare(event);
}

void Prompter::Compare(Event event) {
  if (divergence_ || ChangesNothing(*actual_statuses_, event)) return;
  if (IsWrite(event) && tree_->recorded_slots[event.index] == kNoSlot) return;
  actual_statuses_->Apply(event);
  if (at_ == expected_.size()) return Diverge(nullptr, &event);
  if (!IsSame(expected_[at_], event)) return Diverge(&expected_[at_], &event);
  expected_statuses_->Apply(expected_[at_]);
  ++at_;
  ++events_;
  SkipWhatChangesNothing();
}

void Prompter::Finish(Status result) {
  if (divergence_) return;
  if (at_ < expected_.size()) return Diverge(&expected_[at_], nullptr);
  if (result == played_.result) return;
  divergence_ = Divergence{played_.tick, played_.start, tree_->PathOf(0),
                           std::string("the tick ends with ") + ToString(played_.result),
                           std::string("with ") + ToString(result)};
}

void Prompter::Diverge(const Event* expected, const Event* actual) {
  const NodeIndex node = NodeOf(expected ? *expected : *actual);
  divergence_ = Divergence{played_.tick, played_.start,
                           node < tree_->shape.size() ? tree_->PathOf(node) : "",
                           expected ? Describe(*expected) : "the end of the tick",
                           actual ? Describe(*actual) : "the end of the tick"};
}

NodeIndex Prompter::NodeOf(const Event& event) const {
  return IsWrite(event) ? event.writer : event.index;
}

std::string Prompter::Describe(const Event& event) const {
  if (IsWrite(event)) {
    const SlotIndex slot = tree_->recorded_slots[event.index];
    return (event.code == EventCode::kWrite ? "write of {" : "delivery to {") +
           tree_->description->slots[slot].name + "} = " + PrintValueBytes(event.bytes);
  }
  const std::string node = tree_->PathOf(event.index);
  if (event.code == EventCode::kReset) return node + " is halted";
  if (event.is_result()) return node + " returns " + ToString(event.status());
  switch (event.text) {
    case EventText::kMessage:
      return node + " says: " + std::string(event.bytes);
    case EventText::kException:
      return node + " throws: " + std::string(event.bytes);
    case EventText::kInjected:
      return "a result of " + node + " is injected";
  }
  return node;
}

bool Prompter::HasDrained(NodeIndex node) const { return HasDrainedIn(begin(), end(), node); }

Value Prompter::ValueOf(const Event& event) const {
  return PlayedValue(event.bytes, tree_->program->layout.slots[event.index].type);
}

// The status that somebody outside is about to put in the node's place: its own events come first
// if it is halted for that, but not its own result.
std::optional<Status> Prompter::InjectedNext(NodeIndex node) const {
  for (const Event* event = begin(); event != end(); ++event) {
    if (IsInjected(*event, node)) return static_cast<Status>(event->bytes[0]);
    const NodeIndex of = NodeOf(*event);
    if (event->is_result() && of == node) return std::nullopt;
    if (of < node || of >= shape()[node].end) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Status> Prompter::Before(NodeIndex node) {
  return Sync() ? InjectedNext(node) : std::nullopt;
}

std::optional<Status> Prompter::After(NodeIndex node, Status) {
  return Sync() ? InjectedNext(node) : std::nullopt;
}

}  // namespace coppice
