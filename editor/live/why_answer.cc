#include "editor/live/why_answer.h"

#include <optional>

#include "bt_core/analysis/why/why_text.h"

namespace coppice::editor {

namespace {

// Only of the tick that goes on; between ticks it stands at no node.
DebugStop StopIn(const RunView& view) {
  const DebugStop& stop = view.stop();
  const bool is_at_node =
      stop.where == DebugStop::Where::kBefore || stop.where == DebugStop::Where::kAfter;
  const bool is_shown =
      view.playhead().is_at_now() && stop.node < view.tree()->recorded().shape.size();
  return is_at_node && is_shown ? stop : DebugStop();
}

}  // namespace

void WhyAnswer::Ask(const RunView& view, NodeIndex node) {
  const Recording& run = view.run().recording();
  const std::size_t tick = view.playhead().tick();
  const DebugStop stop = StopIn(view);
  const Question question{&view, view.tree().get(), tick,     run.ticks()[tick].words,
                          node,  stop.where,        stop.node};
  if (question.view == asked_.view && question.tree == asked_.tree &&
      question.tick == asked_.tick && question.words == asked_.words &&
      question.node == asked_.node && question.stop == asked_.stop &&
      question.stop_at == asked_.stop_at) {
    return;
  }
  asked_ = question;
  lines_.clear();
  why_not_.clear();
  is_untold_ = false;
  change_.clear();
  stands_.clear();
  const RecordedTree& tree = view.tree()->recorded();
  // Behind the last tick the robot may have got another tree, of which nothing has happened yet.
  const TickView now = run.Before(tick);
  if (node >= tree.shape.size() || now.statuses.size() != tree.shape.size()) return;
  const std::optional<std::size_t> tick_before = run.TickBefore(tick);
  std::optional<TickView> before;
  if (tick_before) before = run.Before(*tick_before);
  const Why why = WhyOf(tree, now, before ? &*before : nullptr, node);
  for (const WhyStep& step : why.steps) {
    const bool is_news = before && step.before != step.result;
    lines_.push_back({step.node, step.depth, step.result, tree.NameOf(step.node),
                      ReasonOf(tree, step), step.is_asked, is_news});
  }
  is_untold_ = why.is_untold();
  if (stop.where != DebugStop::Where::kNowhere) {
    const bool is_before = stop.where == DebugStop::Where::kBefore;
    stands_ =
        (is_before ? "stopped before \"" : "stopped after \"") + tree.NameOf(stop.node) + "\"";
  }
  const bool is_said =
      !stands_.empty() && why.why_not && why.why_not->cause == WhyNot::Cause::kNotWhole;
  if (why.why_not && !is_said) why_not_ = SentenceOf(tree, *why.why_not);
  if (why.change) {
    change_ = SentenceOf(tree, *why.change);
    changed_node_ = why.change->step.node;
  }
}

}  // namespace coppice::editor
