#include "editor/panels/panel.h"
#include "editor/panels/run_bodies.h"
#include "editor/panels/run_text.h"

namespace coppice::editor {
namespace {

void Write(const Ui& ui, const Row& row, const std::string& text, Face face, Color color) {
  if (!row.visible) return;
  ui.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{8 * ui.scale, 0}, row.box.height(),
             text, {face, 12, color}, row.box.width() - 16 * ui.scale);
}

void GoTo(EditorState& state, RunView& run, std::uint64_t tick, const std::string& path) {
  run.playhead().GoToTick(run.run().recording().Find(tick));
  const auto& nodes = run.tree()->description()->nodes;
  for (NodeIndex i = 0; i < nodes.size(); ++i) {
    if (nodes[i].path == path) return SelectRunNode(state, i);
  }
}

// The other runs that are open.
void OfferRuns(const Ui& ui, EditorState& state, const RunView& run) {
  bool any = false;
  for (const auto& other : state.workspace.runs()) {
    if (other.get() == &run || other->run().size() == 0) continue;
    any = true;
    const Row row = NextRow(ui, "run/compare/" + other->name(), false);
    Write(ui, row, "compare with " + other->name(), Face::kSans, ui.palette.link);
    if (!row.clicked) continue;
    state.comparison.first = run.name();
    state.comparison.second = other->name();
    state.comparison.result = CompareRuns(run.run().recording(), other->run().recording());
  }
  if (!any) Hint(ui, "Open another record, or connect to another robot, to compare with.");
}

}  // namespace

void DrawComparison(const Ui& ui, EditorState& state, RunView& run) {
  const ShownComparison& shown = state.comparison;
  if (!shown.result || shown.first != run.name()) return OfferRuns(ui, state, run);
  const RunComparison result = *shown.result;
  const Row head = NextRow(ui, "run/compare", false);
  Write(ui, head,
        "compared with " + shown.second + ": " + std::to_string(result.different_ticks) + " of " +
            std::to_string(result.ticks) + " ticks differ (click: compare with another)",
        Face::kBold, ui.palette.text);
  if (head.clicked) {
    state.comparison = ShownComparison();
    return;
  }
  if (result.parting) {
    const PartingPoint& at = *result.parting;
    const Row row = NextRow(ui, "run/parting", false);
    Write(ui, row,
          "they part in tick " + std::to_string(at.tick) + " at " + at.what + ": here " + at.first +
              ", there " + at.second,
          Face::kBold, ui.palette.accent);
    if (row.clicked) GoTo(state, run, at.tick, at.what);
  } else {
    Hint(ui, "They do not differ.");
  }
  for (std::size_t i = 0; i < result.differences.size(); ++i) {
    const RunDifference& one = result.differences[i];
    const Row row = NextRow(ui, "run/difference/" + std::to_string(i), false);
    Write(ui, row,
          one.what + "   in " + std::to_string(one.ticks) + " ticks, first in " +
              std::to_string(one.first_tick) + ": here " + one.first + ", there " + one.second,
          Face::kSans, ui.palette.text);
    if (row.clicked) GoTo(state, run, one.first_tick, one.what);
  }
  for (const std::string& path : result.only_first) {
    Write(ui, NextRow(ui, "run/only_first/" + path, false), path + "   only here", Face::kSans,
          ui.palette.text_dim);
  }
  for (const std::string& path : result.only_second) {
    Write(ui, NextRow(ui, "run/only_second/" + path, false), path + "   only there", Face::kSans,
          ui.palette.text_dim);
  }
}

}  // namespace coppice::editor
