#include <algorithm>
#include <cstdio>

#include "editor/commands/run_commands.h"
#include "editor/panels/run/run_bodies.h"
#include "editor/panels/run/run_text.h"
#include "editor/panels/widgets/panel.h"

namespace coppice::editor {
namespace {

std::string Percent(std::uint64_t part, std::uint64_t all) {
  char text[16];
  std::snprintf(text, sizeof(text), "%.0f %%",
                all == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(all));
  return text;
}

double Seconds(Duration duration) { return static_cast<double>(duration.count()) * 1e-9; }

class Table {
 public:
  Table(const Ui& ui, EditorState& state, float width) : ui_(ui), state_(state) {
    constexpr float kWidths[] = {46, 60, 56, 50, 50, 60};
    float x = width - 8 * ui.scale;
    for (std::size_t i = kColumns; i-- > 0;) {
      right_[i] = x;
      x -= kWidths[i] * ui.scale;
    }
    name_ = x;
  }

  void Head() {
    const Row row = NextRow(ui_, "run/figures", false);
    if (!row.visible) return;
    ui_.Fill(*ImGui::GetWindowDrawList(), row.box, Fade(ui_.palette.header, 0.6F));
    if (row.hovered) {
      Tooltip(
          ui_,
          "ticks: how often the node was ticked\nSUCCESS, FAILURE: share of its ticks that ended "
          "this way\np50, p95: how long it ran until it had a result, in 50 % and 95 % of all\n"
          "cases, without the time at breakpoints and in pauses\n"
          "flips/min: how often its result changed");
    }
    Write(row, "node", {"ticks", "SUCCESS", "FAILURE", "p50", "p95", "flips/min"},
          ui_.palette.text_dim, ui_.palette.text_dim);
  }

  void Line(const NodeStatistics& node, NodeIndex number, bool selected) {
    const Row row = NextRow(ui_, "run/figures/" + node.path, selected);
    if (row.clicked) SelectRunNode(state_, number);
    if (row.hovered) Tooltip(ui_, node.path);
    if (!row.visible) return;
    char flips[16];
    std::snprintf(flips, sizeof(flips), "%.1f", node.flips_per_minute);
    const bool runs = node.activations.count > 0;
    Write(row, node.path,
          {std::to_string(node.ticks), Percent(node.results_of(Status::kSuccess), node.ticks),
           Percent(node.results_of(Status::kFailure), node.ticks),
           runs ? DurationText(Seconds(node.activations.p50)) : "",
           runs ? DurationText(Seconds(node.activations.p95)) : "", node.flips ? flips : ""},
          node.ticks ? ui_.palette.text : ui_.palette.text_dim, ui_.palette.text);
  }

 private:
  static constexpr std::size_t kColumns = 6;

  void Write(const Row& row, const std::string& name, const std::string (&cells)[kColumns],
             Color name_color, Color color) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = 8 * ui_.scale;
    const TextStyle name_style{Face::kSans, 12, name_color};
    ui_.RowText(list, row.box.min + Point{pad, 0}, row.box.height(),
                ui_.CutStart(name, name_style, std::max(name_ - 2 * pad, 40 * ui_.scale)),
                name_style);
    for (std::size_t i = 0; i < kColumns; ++i) {
      const TextStyle style{Face::kSans, 11, color};
      const float width = ui_.Width(cells[i], style);
      ui_.RowText(list, {row.box.min.x + right_[i] - width, row.box.min.y}, row.box.height(),
                  cells[i], style);
    }
  }

  const Ui& ui_;
  EditorState& state_;
  float right_[kColumns];
  float name_;
};

}  // namespace

void DrawStatistics(const Ui& ui, EditorState& state, RunView& run) {
  const TimelineState& timeline = state.run.timelines[run.name()];
  state.run.figures.Update(run.run(), timeline.range);
  const bool is_paused = run.stop().where != DebugStop::Where::kNowhere;
  TextRow(ui, "run/figures/all",
          SentenceOf(state.run.figures.statistics(), timeline.range.has_value(), is_paused),
          {Face::kSans, 12, ui.palette.text});
  Table table(ui, state, ImGui::GetContentRegionAvail().x);
  table.Head();
  const auto& nodes = run.tree()->description()->nodes;
  const TreeView* view = state.workspace.view();
  const NodeIndex selected = view ? view->selected_run_node() : kNoNode;
  for (NodeIndex i{0}; i < nodes.size(); ++i) {
    const NodeStatistics* node = state.run.figures.Find(nodes[i].path);
    if (node) table.Line(*node, i, i == selected);
  }
}

}  // namespace coppice::editor
