// A tick with all that can be asked about it: its walk, and what each step read. Why and why-not
// are told from it.
#ifndef COPPICE_BT_CORE_ANALYSIS_WHY_TICK_STORY_H_
#define COPPICE_BT_CORE_ANALYSIS_WHY_TICK_STORY_H_

#include <optional>
#include <vector>

#include "bt_core/analysis/why/why.h"

namespace coppice {

class TickStory {
 public:
  /// Both must live longer. `before` is the tick before, or null.
  TickStory(const RecordedTree& tree, const TickView& view, const TickStory* before);

  const RecordedTree& tree() const { return tree_; }
  const TickView& view() const { return view_; }
  const Walk& walk() const { return walk_; }

  /// Status of every node after the tick.
  const std::vector<Status>& statuses_after() const { return after_; }

  WhyStep Explain(StepIndex step) const;

  /// True if nodes without a step may have been ticked all the same (tree_description.h).
  bool tells_changes_only() const { return TellsChangesOnly(tree_.description->info); }

  /// The first step, at the latest `last` (kNoStep: any) in order of completion, that differs from
  /// the tick before.
  std::optional<WhyChange> FirstChange(StepIndex last) const;

 private:
  void AddCause(StepIndex step, WhyStep& why) const;
  bool AddGuard(StepIndex step, const SlotValues& values, WhyStep& why) const;
  void AddScript(const SlotValues& values, WhyStep& why) const;
  void AddTexts(StepIndex step, WhyStep& why) const;
  std::vector<WhyValue> Read(const std::vector<Reading>& readings, NodeIndex node,
                             const SlotValues& values) const;
  std::uint32_t DepthOf(StepIndex step) const;

  const RecordedTree& tree_;
  const TickView& view_;
  const TickStory* before_;
  Walk walk_;
  std::vector<Status> after_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_WHY_TICK_STORY_H_
