// Why a node has the status that it has after a tick, and why it was not ticked.
//
//   const TickView now = run.Before(i), before = run.Before(*run.TickBefore(i));
//   const Why why = WhyOf(tree, now, &before, node);
//   std::cout << PrintWhy(tree, why);      // why_text.h
//
// The answer is read off the walk (walk.h), so it is right for every node, also for those of the
// user: an inner node has its result because of what its children returned, a leaf because of what
// it read and said. Scripts and ports come from the compiled tree; without it (RecordedTree) they
// are missing and the rest holds.
#ifndef COPPICE_BT_CORE_ANALYSIS_WHY_WHY_H_
#define COPPICE_BT_CORE_ANALYSIS_WHY_WHY_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/analysis/why/readings.h"

namespace coppice {

/// A value that a node read.
struct WhyValue {
  std::string name;                   ///< of the port; in a script, of the key
  std::string key;                    ///< the same in a script
  std::string value;                  ///< bytes as in data/value_bytes.h
  std::optional<std::string> before;  ///< what it read the last tick; nothing: it was not ticked
  bool has_changed() const { return before && *before != value; }
};

/// A script of the node, with its answer if it was asked for one.
struct WhyScript {
  std::string attribute;  ///< "_skipIf", "code"
  std::string text;
  std::optional<bool> answer;  ///< nothing: it threw, or is the code of an action
  std::vector<WhyValue> values;
};

/// What made a step end as it did.
enum class WhyCause : std::uint8_t {
  kOwn,        ///< the node itself: a leaf, or an inner node that ticked no child
  kChild,      ///< its child `decisive`
  kGuard,      ///< its guard `script`; the node itself was not ticked
  kScript,     ///< its script, with the answer
  kException,  ///< it threw `text`
  kInjected,   ///< somebody outside decided
  kHalted,     ///< no tick: it was halted, or made idle
};

/// One tick of one node, on the way to the answer.
struct WhyStep {
  NodeIndex node;
  std::uint32_t depth;  ///< below the root of the walk
  Status result;
  std::optional<Status> before;  ///< its result in the tick before; nothing: it was not ticked
                                 ///< then. Where only changes are told, the status that it had
  WhyCause cause = WhyCause::kOwn;
  NodeIndex decisive = kNoNode;
  std::optional<WhyScript> script;
  std::vector<WhyValue> values;       ///< of its ports
  std::vector<std::string> messages;  ///< what it said
  std::string text;                   ///< of the exception
  bool is_asked = false;              ///< the node in question
};

/// The first step that went another way than in the tick before.
struct WhyChange {
  WhyStep step;
  bool was_ticked_before;
};

/// What kept a node from being ticked.
struct WhyNot {
  enum class Cause : std::uint8_t {
    kNoTick,      ///< this was no tick, but a halt or something between two ticks
    kChild,       ///< `by` did not come to it: `child` before it decided
    kDone,        ///< `by` did not tick it again: it has ended with `status` before
    kPassedOver,  ///< `by` ticked others, not this one
    kOwn,         ///< `by` ticked no child: a guard, a script or itself; see its step
    kInjected,    ///< somebody outside decided for `by`
    kNotWhole,    ///< the tick stands at a breakpoint, before or in `by`
    kAborted,     ///< the tick was ended by an exception of `by`
    kNotTold,     ///< nobody knows: of this run only changes were told, and none of it
  };
  Cause cause;
  NodeIndex by{0};            ///< the nearest ancestor that was ticked
  NodeIndex towards{0};       ///< its child that is, or leads to, the node in question
  NodeIndex child = kNoNode;  ///< of `by`
  Status status = Status::kIdle;
};

struct Why {
  std::uint64_t tick;
  Time time;
  NodeIndex node;
  Status status;    ///< after the tick
  bool was_ticked;  ///< in this tick, as far as told
  /// The walk from the root to the node in question or to what kept it from being ticked: its
  /// ancestors, what they ticked before, and what is below it; in the order of entering. Of a tick
  /// that stands at a breakpoint, and has not come to the node: what has ended so far.
  std::vector<WhyStep> steps;
  std::optional<WhyChange> change;  ///< nothing: everything on the way was as in the tick before
  std::optional<WhyNot> why_not;

  /// Whether it was ticked is not told.
  bool is_untold() const { return why_not && why_not->cause == WhyNot::Cause::kNotTold; }
};

/// `before` may be null: then nothing is said of changes.
Why WhyOf(const RecordedTree& tree, const TickView& now, const TickView* before, NodeIndex node);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_WHY_WHY_H_
