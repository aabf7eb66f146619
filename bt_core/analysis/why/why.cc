#include "bt_core/analysis/why/why.h"

#include "bt_core/analysis/why/tick_story.h"
#include "bt_core/analysis/why/why_not.h"

namespace coppice {
namespace {

// Picks the steps that are worth telling.
class Teller {
 public:
  Teller(const TickStory& story, NodeIndex asked, std::vector<WhyStep>& steps)
      : story_(story), asked_(asked), steps_(steps) {}

  /// What has ended so far in a tick that stands.
  void TellSoFar() {
    const std::vector<WalkStep>& steps = story_.walk().steps;
    for (StepIndex i = 0; i < steps.size(); i = steps[i].end) TellDecisive(i);
  }

  /// From the root to a step: each ancestor with what it ticked before, then the step with all that
  /// it ticked.
  void TellWayTo(StepIndex step) {
    const StepIndex parent = story_.walk().steps[step].parent;
    if (parent != kNoStep) {
      TellAncestor(parent);
      TellChildrenBefore(parent, step);
    }
    TellWhole(step);
  }

 private:
  void TellAncestor(StepIndex step) {
    const StepIndex parent = story_.walk().steps[step].parent;
    if (parent != kNoStep) {
      TellAncestor(parent);
      TellChildrenBefore(parent, step);
    }
    Add(step);
  }

  void TellChildrenBefore(StepIndex parent, StepIndex end) {
    for (const StepIndex child : story_.walk().ChildrenOf(parent)) {
      if (child >= end) return;
      TellDecisive(child);
    }
  }

  // What decided, down to the leaf.
  void TellDecisive(StepIndex step) {
    for (; step != kNoStep; step = story_.walk().Decisive(step)) Add(step);
  }

  void TellWhole(StepIndex step) {
    Add(step);
    const StepIndex decisive = story_.walk().Decisive(step);
    for (const StepIndex child : story_.walk().ChildrenOf(step)) {
      if (child == decisive) {
        TellWhole(child);
      } else {
        TellDecisive(child);
      }
    }
  }

  void Add(StepIndex step) {
    steps_.push_back(story_.Explain(step));
    steps_.back().is_asked = steps_.back().node == asked_;
  }

  const TickStory& story_;
  const NodeIndex asked_;
  std::vector<WhyStep>& steps_;
};

}  // namespace

Why WhyOf(const RecordedTree& tree, const TickView& now, const TickView* before, NodeIndex node) {
  std::optional<TickStory> earlier;
  if (before) earlier.emplace(tree, *before, nullptr);
  const TickStory story(tree, now, earlier ? &*earlier : nullptr);
  StepIndex step = story.walk().LastStepOf(node);

  Why why;
  why.tick = now.events.tick;
  why.time = now.events.start;
  why.node = node;
  why.status = story.statuses_after()[node];
  why.was_ticked = step != kNoStep;
  if (!why.was_ticked) {
    why.why_not = WhyNotOf(story, node);
    step = story.walk().LastStepOf(why.why_not->by);
  }
  if (why.is_untold()) why.change = story.FirstChange(kNoStep);
  const bool stands = why.why_not && why.why_not->cause == WhyNot::Cause::kNotWhole;
  if (stands) Teller(story, node, why.steps).TellSoFar();
  if (step == kNoStep || why.is_untold()) return why;
  Teller(story, node, why.steps).TellWayTo(step);
  why.change = story.FirstChange(step);
  return why;
}

}  // namespace coppice
