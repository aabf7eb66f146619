#include "editor/live/why_answer.h"

#include <optional>

#include "bt_core/analysis/why/why_text.h"

namespace coppice::editor {

void WhyAnswer::Ask(const RunView& view, NodeIndex node) {
  const Recording& run = view.run().recording();
  const std::size_t tick = view.playhead().tick();
  const Question question{&view, view.tree().get(), tick, run.ticks()[tick].words, node};
  if (question.view == asked_.view && question.tree == asked_.tree &&
      question.tick == asked_.tick && question.words == asked_.words &&
      question.node == asked_.node) {
    return;
  }
  asked_ = question;
  lines_.clear();
  why_not_.clear();
  is_untold_ = false;
  change_.clear();
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
  if (why.why_not) why_not_ = SentenceOf(tree, *why.why_not);
  if (why.change) {
    change_ = SentenceOf(tree, *why.change);
    changed_node_ = why.change->step.node;
  }
}

}  // namespace coppice::editor
