#include <utility>

#include "bt_core/analysis/difference_text.h"
#include "editor/commands/difference_commands.h"
#include "editor/panels/run/run_bodies.h"
#include "editor/panels/widgets/difference_list.h"
#include "editor/panels/widgets/panel.h"

namespace coppice::editor {
namespace {

// The other runs that are open.
void OfferRuns(const Ui& ui, EditorState& state, const RunView& run) {
  bool any = false;
  for (const auto& other : state.workspace.runs()) {
    if (other.get() == &run || other->run().size() == 0) continue;
    if (!std::exchange(any, true)) Hint(ui, "Compare this run with:");
    const Row row = TextRow(ui, "run/compare/" + other->name(), other->name(),
                            {Face::kSans, 12, ui.palette.link});
    if (!row.clicked) continue;
    state.run.comparison = {run.name(),
                            other->name(),
                            CompareRuns(run.run().recording(), other->run().recording()),
                            {}};
  }
  if (!any) Hint(ui, "Open another record or connect to another robot to compare with.");
}

}  // namespace

void DrawComparison(const Ui& ui, EditorState& state, RunView& run) {
  const RunComparison* const shown = ShownRunComparison(state);
  if (!shown) return OfferRuns(ui, state, run);
  const RunComparison& result = *shown;
  const TextStyle bold{Face::kBold, 12, ui.palette.text};
  const Row head = TextRow(
      ui, "run/compare",
      "compared with " + state.run.comparison.second + ": " +
          std::to_string(result.different_ticks) + " of " + Count(result.ticks, "tick") +
          (result.different_ticks == 1 ? " differs" : " differ") + " (click: compare with another)",
      bold);
  if (head.clicked) {
    state.run.comparison = ShownComparison();
    return;
  }
  if (result.parting) {
    const Row row =
        TextRow(ui, "run/parting", Sentence(*result.parting), {Face::kBold, 12, ui.palette.accent});
    if (row.clicked) GoToRunNode(state, result.parting->tick, result.parting->what);
  } else {
    Hint(ui, "The two runs do not differ.");
  }
  if (!result.differences.empty()) {
    const Row row = NextRow(ui, "run/differences", false);
    DrawDifferenceButtons(ui, state, {row.box.max.x - 8 * ui.scale, row.box.min.y},
                          row.box.height());
  }
  for (std::size_t i = 0; i < result.differences.size(); ++i) {
    const bool is_selected = state.run.comparison.selected == i;
    const Row row =
        TextRow(ui, "run/difference/" + std::to_string(i), Sentence(result.differences[i]),
                {is_selected ? Face::kBold : Face::kSans, 12, ui.palette.text});
    if (row.clicked) ShowRunDifference(state, i);
  }
  const TextStyle dim{Face::kSans, 12, ui.palette.text_dim};
  for (const std::string& path : result.only_first) {
    TextRow(ui, "run/only_first/" + path, "\"" + path + "\" exists in this run only", dim);
  }
  for (const std::string& path : result.only_second) {
    TextRow(ui, "run/only_second/" + path, "\"" + path + "\" exists in the other run only", dim);
  }
}

}  // namespace coppice::editor
