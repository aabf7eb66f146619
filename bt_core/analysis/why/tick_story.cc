#include "bt_core/analysis/why/tick_story.h"

namespace coppice {

TickStory::TickStory(const RecordedTree& tree, const TickView& view, const TickStory* before)
    : tree_(tree),
      view_(view),
      before_(before),
      walk_(WalkOf(tree.shape, view.events.words, &view.statuses)) {
  StatusFollower follower(tree.shape, view.statuses);
  for (const Event& event : walk_.events) follower.Apply(event);
  after_ = follower.statuses();
}

WhyStep TickStory::Explain(StepIndex index) const {
  const WalkStep& step = walk_.steps[index];
  WhyStep why;
  why.node = step.node;
  why.depth = DepthOf(index);
  why.result = step.result;
  if (tells_changes_only()) {
    why.before = view_.statuses[step.node];
  } else if (before_) {
    const StepIndex last = before_->walk_.LastStepOf(step.node);
    if (last != kNoStep) why.before = before_->walk_.steps[last].result;
  }
  AddTexts(index, why);
  AddCause(index, why);
  return why;
}

void TickStory::AddCause(StepIndex index, WhyStep& why) const {
  const WalkStep& step = walk_.steps[index];
  if (step.result == Status::kIdle) {
    why.cause = WhyCause::kHalted;
    return;
  }
  const SlotValues values = ValuesAt(view_, walk_, tree_.shape, index);
  const StepIndex decisive = walk_.Decisive(index);
  if (step.is_injected) {
    why.cause = WhyCause::kInjected;
  } else if (decisive == kNoStep && AddGuard(index, values, why)) {
    return;
  } else if (!why.text.empty()) {
    why.cause = WhyCause::kException;
  } else if (decisive != kNoStep) {
    why.cause = WhyCause::kChild;
    why.decisive = walk_.steps[decisive].node;
  } else {
    AddScript(values, why);
  }
  why.values = Read(PortReadings(tree_, why.node), why.node, values);
}

bool TickStory::AddGuard(StepIndex index, const SlotValues& values, WhyStep& why) const {
  const bool running = view_.statuses[why.node] == Status::kRunning;
  const std::optional<GuardDecision> decision = DecideGuards(tree_, why.node, running, values);
  if (!decision || decision->result != walk_.steps[index].result) return false;
  why.cause = WhyCause::kGuard;
  why.script =
      WhyScript{std::string(decision->script.attribute), decision->script.text, decision->answer,
                Read(ScriptReadings(tree_, decision->script), why.node, values)};
  return true;
}

// What the script of an action is worth decides nothing.
void TickStory::AddScript(const SlotValues& values, WhyStep& why) const {
  for (const NodeScript& script : ScriptsOf(tree_, why.node)) {
    if (script.guard) continue;
    const bool is_asked =
        tree_.program->info[why.node].entry->manifest.category != NodeCategory::kAction;
    why.cause = WhyCause::kScript;
    why.script = WhyScript{std::string(script.attribute), script.text,
                           is_asked ? Test(tree_, script, values) : std::nullopt,
                           Read(ScriptReadings(tree_, script), why.node, values)};
    return;
  }
}

// What the node said since it was entered, and not while it was halted before that.
void TickStory::AddTexts(StepIndex index, WhyStep& why) const {
  const WalkStep& step = walk_.steps[index];
  for (std::uint32_t i = step.entry; i < step.event; ++i) {
    const Event& event = walk_.events[i];
    if (event.code != EventCode::kText || event.index != step.node) continue;
    if (event.text == EventText::kMessage) why.messages.emplace_back(event.bytes);
    if (event.text == EventText::kException) why.text = event.bytes;
  }
}

std::vector<WhyValue> TickStory::Read(const std::vector<Reading>& readings, NodeIndex node,
                                      const SlotValues& values) const {
  std::vector<WhyValue> read;
  if (readings.empty()) return read;
  std::optional<SlotValues> earlier;
  if (before_) {
    const StepIndex last = before_->walk_.LastStepOf(node);
    if (last != kNoStep) {
      earlier = ValuesAt(before_->view_, before_->walk_, tree_.shape, last);
    }
  }
  for (const Reading& reading : readings) {
    WhyValue value{reading.name, reading.key, values[reading.slot], std::nullopt};
    if (earlier) value.before = (*earlier)[reading.slot];
    read.push_back(std::move(value));
  }
  return read;
}

std::optional<WhyChange> TickStory::FirstChange(StepIndex last) const {
  const bool changes_only = tells_changes_only();
  if (!before_ && !changes_only) return std::nullopt;
  const StepIndex first = FirstDifference(walk_, changes_only ? Walk() : before_->walk_);
  if (first == kNoStep) return std::nullopt;
  if (last != kNoStep && walk_.steps[first].event > walk_.steps[last].event) return std::nullopt;
  const WhyStep step = Explain(first);
  return WhyChange{step, step.before.has_value()};
}

std::uint32_t TickStory::DepthOf(StepIndex step) const {
  std::uint32_t depth = 0;
  StepIndex top = step;
  for (; walk_.steps[top].parent != kNoStep; top = walk_.steps[top].parent) ++depth;
  if (view_.events.is_whole) return depth;
  // What is above it has not ended, so it has no steps yet.
  for (NodeIndex node = walk_.steps[top].node; tree_.shape[node].parent != node; ++depth) {
    node = tree_.shape[node].parent;
  }
  return depth;
}

}  // namespace coppice
