#include <utility>

#include "editor/panels/run/run_bodies.h"
#include "editor/panels/run/run_text.h"
#include "editor/panels/widgets/panel.h"

namespace coppice::editor {
namespace {

void GoTo(EditorState& state, RunView& run, std::uint64_t tick, const std::string& path) {
  run.playhead().GoToTick(run.run().recording().Find(tick));
  const auto& nodes = run.tree()->description()->nodes;
  for (NodeIndex i{0}; i < nodes.size(); ++i) {
    if (nodes[i].path == path) return SelectRunNode(state, i);
  }
}

// The other runs that are open.
void OfferRuns(const Ui& ui, EditorState& state, const RunView& run) {
  bool any = false;
  for (const auto& other : state.workspace.runs()) {
    if (other.get() == &run || other->run().size() == 0) continue;
    if (!std::exchange(any, true)) Hint(ui, "Compare this run with:");
    const Row row = TextRow(ui, "run/compare/" + other->name(), other->name(),
                            {Face::kSans, 12, ui.palette.link});
    if (!row.clicked) continue;
    state.run.comparison.first = run.name();
    state.run.comparison.second = other->name();
    state.run.comparison.result = CompareRuns(run.run().recording(), other->run().recording());
  }
  if (!any) Hint(ui, "Open another record, or connect to another robot, to compare with.");
}

}  // namespace

void DrawComparison(const Ui& ui, EditorState& state, RunView& run) {
  const ShownComparison& shown = state.run.comparison;
  if (!shown.result || shown.first != run.name()) return OfferRuns(ui, state, run);
  const RunComparison result = *shown.result;
  const TextStyle bold{Face::kBold, 12, ui.palette.text};
  const Row head =
      TextRow(ui, "run/compare",
              "compared with " + shown.second + ": " + std::to_string(result.different_ticks) +
                  " of " + Count(result.ticks, "tick") + " differ (click: compare with another)",
              bold);
  if (head.clicked) {
    state.run.comparison = ShownComparison();
    return;
  }
  if (result.parting) {
    const PartingPoint& at = *result.parting;
    const Row row = TextRow(ui, "run/parting",
                            "They part in tick " + std::to_string(at.tick) + ": \"" + at.what +
                                "\" is " + at.first + " here, " + at.second + " there",
                            {Face::kBold, 12, ui.palette.accent});
    if (row.clicked) GoTo(state, run, at.tick, at.what);
  } else {
    Hint(ui, "They do not differ.");
  }
  for (std::size_t i = 0; i < result.differences.size(); ++i) {
    const RunDifference& one = result.differences[i];
    const Row row = TextRow(ui, "run/difference/" + std::to_string(i),
                            "\"" + one.what + "\" differs in " + Count(one.ticks, "tick") +
                                ", first in tick " + std::to_string(one.first_tick) + ": " +
                                one.first + " here, " + one.second + " there",
                            {Face::kSans, 12, ui.palette.text});
    if (row.clicked) GoTo(state, run, one.first_tick, one.what);
  }
  const TextStyle dim{Face::kSans, 12, ui.palette.text_dim};
  for (const std::string& path : result.only_first) {
    TextRow(ui, "run/only_first/" + path, path + "   only here", dim);
  }
  for (const std::string& path : result.only_second) {
    TextRow(ui, "run/only_second/" + path, path + "   only there", dim);
  }
}

}  // namespace coppice::editor
