#include "bt_core/analysis/why/why_not.h"

#include <algorithm>

namespace coppice {
namespace {

// The nodes whose first child chooses among the others.
bool IsChosenByFirstChild(const RecordedTree& tree, NodeIndex node) {
  if (!tree.program) return false;
  const NodeType type = tree.program->nodes[node].type;
  return type == NodeType::kIfThenElse || type == NodeType::kWhileDoElse;
}

WhyNot NotTold(const TickStory& story, NodeIndex node) {
  return {WhyNot::Cause::kNotTold, node, node, kNoNode, story.statuses_after()[node]};
}

bool HasStatusEvents(const Walk& walk) {
  return std::any_of(walk.events.begin(), walk.events.end(),
                     [](const Event& event) { return event.is_status(); });
}

// A tick of the root that has no result of the root.
WhyNot WithoutRoot(const TickStory& story, NodeIndex node) {
  using Cause = WhyNot::Cause;
  const TickEvents& events = story.view().events;
  if (story.tells_changes_only() && HasStatusEvents(story.walk())) return NotTold(story, node);
  if (!events.is_whole) return {Cause::kNotWhole, node, node, kNoNode, Status::kIdle};
  if (events.result == Status::kIdle) return {Cause::kNoTick, node, node, kNoNode, Status::kIdle};
  for (const Event& event : story.walk().events) {
    const bool is_exception = event.code == EventCode::kText && event.text == EventText::kException;
    if (is_exception) return {Cause::kAborted, event.node(), node, kNoNode, events.result};
  }
  return NotTold(story, node);
}

// The children of a step that were ticked, in order.
std::vector<const WalkStep*> TickedChildren(const Walk& walk, StepIndex step) {
  std::vector<const WalkStep*> ticked;
  for (const StepIndex child : walk.ChildrenOf(step)) {
    if (walk.steps[child].result != Status::kIdle) ticked.push_back(&walk.steps[child]);
  }
  return ticked;
}

}  // namespace

WhyNot WhyNotOf(const TickStory& story, NodeIndex node) {
  using Cause = WhyNot::Cause;
  const Walk& walk = story.walk();
  NodeIndex towards = node;
  NodeIndex by = node;
  StepIndex step = kNoStep;
  while (step == kNoStep) {
    towards = by;
    by = story.tree().shape[towards].parent;
    if (by == towards) return WithoutRoot(story, node);
    step = walk.LastStepOf(by);
  }
  // A node that was ticked while it was idle has changed.
  const bool changes_only = story.tells_changes_only();
  if (changes_only && story.view().statuses[towards] != Status::kIdle) return NotTold(story, node);
  WhyNot why{Cause::kOwn, by, towards, kNoNode, walk.steps[step].result};
  const std::vector<const WalkStep*> ticked = TickedChildren(walk, step);
  if (ticked.empty()) {
    if (changes_only) return NotTold(story, node);
    if (walk.steps[step].is_injected) why.cause = Cause::kInjected;
    return why;
  }
  const Status earlier = story.view().statuses[towards];
  if (earlier != Status::kIdle && earlier != Status::kRunning) {
    why.cause = Cause::kDone;
    why.status = earlier;
    return why;
  }
  const WalkStep* decisive = ticked.back();
  if (IsChosenByFirstChild(story.tree(), by) && ticked.front()->node == by + 1) {
    decisive = ticked.front();
  }
  why.cause = decisive->node < towards ? Cause::kChild : Cause::kPassedOver;
  why.child = decisive->node;
  why.status = decisive->result;
  return why;
}

}  // namespace coppice
