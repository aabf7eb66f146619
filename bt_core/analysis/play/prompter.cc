#include "bt_core/analysis/play/prompter.h"

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
  return event.code == EventCode::kReset && statuses.status(event.node()) == Status::kIdle;
}

}  // namespace

bool IsAboutStopping(const Event& event) {
  constexpr std::string_view kGivenUp = "has not stopped in time";
  constexpr std::string_view kThrew = "while stopping: ";
  return event.code == EventCode::kText && (event.bytes.substr(0, kGivenUp.size()) == kGivenUp ||
                                            event.bytes.substr(0, kThrew.size()) == kThrew);
}

bool IsInjected(const Event& event) {
  return event.code == EventCode::kText && event.text == EventText::kInjected &&
         event.bytes.size() == 1;
}

// What the node's hook writes when it is halted is not followed by its result.
bool StoppingNode::Follow(const Event& event) {
  const bool has_written = has_written_;
  has_written_ = event.code == EventCode::kWrite && event.writer == node_;
  if (IsWrite(event) || event.index != node_) return true;
  if (event.code == EventCode::kText) {
    is_injected_ = event.text == EventText::kInjected;
    return is_injected_;
  }
  const bool is_own = event.is_result() && !is_injected_;
  is_injected_ = false;
  is_waited_for_ = is_own && event.status() == Status::kRunning;
  return !is_own || (is_waited_for_ && !has_written);
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
}

const Event* Prompter::begin_of_change() const {
  const Event* event = begin();
  while (event != end() && ChangesNothing(*expected_statuses_, *event)) ++event;
  return event;
}

bool Prompter::Sync() {
  if (!divergence_) executor_->ReportSoFar();
  return !divergence_;
}

void Prompter::OnTick(const TickEvents& events) {
  EventReader reader(events.words);
  for (Event event; reader.Next(event);) Compare(event);
}

// A reset that changes nothing may be missing on either side.
void Prompter::Compare(Event event) {
  if (divergence_) return;
  if (ChangesNothing(*actual_statuses_, event)) {
    const bool is_expected = begin() != end() && IsSame(*begin(), event) &&
                             ChangesNothing(*expected_statuses_, *begin());
    at_ += is_expected;
    return;
  }
  if (IsWrite(event) && tree_->recorded_slots[event.index] == kNoSlot) return;
  FollowPretending(event);
  actual_statuses_->Apply(event);
  const Event* expected = begin_of_change();
  if (expected == end()) return Diverge(nullptr, &event);
  if (!IsSame(*expected, event)) return Diverge(expected, &event);
  expected_statuses_->Apply(*expected);
  at_ = static_cast<std::size_t>(expected - expected_.data()) + 1;
  ++events_;
}

void Prompter::FollowPretending(const Event& event) {
  if (event.is_status()) {
    const bool goes_on = event.status() == Status::kRunning &&
                         actual_statuses_->status(event.node()) == Status::kRunning;
    if (!goes_on && event.index != injected_) pretending_.erase(event.node());
    if (event.is_result()) injected_ = kNoNode;
  } else if (IsInjected(event)) {
    injected_ = event.node();
    const bool runs = actual_statuses_->status(event.node()) == Status::kRunning;
    if (!runs && static_cast<Status>(event.bytes[0]) == Status::kRunning) {
      pretending_.insert(event.node());
    }
  }
}

void Prompter::Finish(Status result) {
  if (divergence_) return;
  if (begin_of_change() != end()) return Diverge(begin_of_change(), nullptr);
  if (result == played_.result) return;
  divergence_ = Divergence{played_.tick, played_.start, tree_->PathOf(kRootNode),
                           std::string("the tick ends with ") + ToString(played_.result),
                           std::string("with ") + ToString(result)};
}

void Prompter::Diverge(const Event* expected, const Event* actual) {
  const NodeIndex node = NodeOf(expected ? *expected : *actual);
  divergence_ =
      Divergence{played_.tick, played_.start, node < tree_->shape.size() ? tree_->PathOf(node) : "",
                 expected ? Describe(*expected) : "the end of the tick",
                 actual ? Describe(*actual) : "the end of the tick"};
}

NodeIndex Prompter::NodeOf(const Event& event) const {
  return IsWrite(event) ? event.writer : event.node();
}

std::string Prompter::Describe(const Event& event) const {
  if (IsWrite(event)) {
    const SlotIndex slot = tree_->recorded_slots[event.index];
    return (event.code == EventCode::kWrite ? "write of {" : "delivery to {") +
           tree_->description->slots[slot].name + "} = " + PrintValueBytes(event.bytes);
  }
  const std::string node = tree_->PathOf(event.node());
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

bool Prompter::WillDrain(NodeIndex node, const Event* next) const {
  StoppingNode stopping(node, false);
  for (; next != end(); ++next) {
    if (!stopping.Follow(*next)) return false;
  }
  return will_drain_(stopping);
}

Value Prompter::ValueOf(const Event& event) const {
  return PlayedValue(event.bytes, tree_->program->layout.slots[event.index].type);
}

// What runs is halted for that first, so there are other events, but no result of its own.
std::optional<Status> Prompter::InjectedNext(NodeIndex node) const {
  const bool runs = IsRunning(node);
  for (const Event* event = begin(); event != end(); ++event) {
    if (IsInjected(*event) && event->index == node) return static_cast<Status>(event->bytes[0]);
    const NodeIndex of = NodeOf(*event);
    if (of < node || of >= shape()[node].end) return std::nullopt;
    if (of != node || event->code == EventCode::kText) continue;
    if (event->is_result() || !runs) return std::nullopt;
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
