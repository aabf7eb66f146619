#include <algorithm>

#include "editor/commands/run_commands.h"
#include "editor/panels/run/run_bodies.h"
#include "editor/panels/run/run_text.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

constexpr float kIndent = 10;

NodeIndex SelectedNode(EditorState& state) {
  const TreeView* view = state.workspace.view();
  const NodeIndex selected = view ? view->selected_run_node() : kNoNode;
  return selected == kNoNode ? kRootNode : selected;
}

float Indent(const Ui& ui, const WhyLine& line) {
  return (10 + kIndent * static_cast<float>(std::min<std::uint32_t>(line.depth, 10))) * ui.scale;
}

std::string StatusOf(const WhyLine& line) {
  return line.status == Status::kIdle ? "made idle" : ToString(line.status);
}

// The reason stands behind the status if there is room for all of it.
bool FitsIntoALine(const Ui& ui, const WhyLine& line, float width) {
  const float name = ui.Width(line.name, {line.is_asked ? Face::kBold : Face::kSans, 12, 0});
  const float status = ui.Width(StatusOf(line), {Face::kBold, 12, 0});
  const float news = line.is_news ? ui.Width("new", {Face::kSans, 12, 0}) + 8 * ui.scale : 0;
  const float reason = ui.Width(line.reason, {Face::kSans, 12, 0});
  return Indent(ui, line) + name + status + news + reason + 24 * ui.scale <= width;
}

void DrawLine(const Ui& ui, EditorState& state, const WhyLine& line, std::size_t number) {
  const float width = ImGui::GetContentRegionAvail().x;
  const bool fits = FitsIntoALine(ui, line, width);
  const float room = width - Indent(ui, line) - 16 * ui.scale;
  const TextStyle dim{Face::kSans, 12, ui.palette.text_dim};
  const float below = fits ? 0 : ui.ParagraphHeight(line.reason, dim, room) / ui.scale + 4;
  const Row row =
      NextRow(ui, "run/why/" + std::to_string(number), line.is_asked, kRowHeight + below);
  if (row.clicked) SelectRunNode(state, line.node);
  if (row.hovered) Tooltip(ui, line.name + "\n" + line.reason);
  if (!row.visible) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Color color =
      line.status == Status::kIdle ? ui.palette.text_dim : ui.palette.Of(line.status);
  ui.Fill(list, {row.box.min, {row.box.min.x + 3 * ui.scale, row.box.max.y}}, color);
  float x = row.box.min.x + Indent(ui, line);
  if (!fits) {
    ui.Paragraph(list, {x + 8 * ui.scale, row.box.min.y + (kRowHeight - 1) * ui.scale}, line.reason,
                 dim, room);
  }
  const auto write = [&](const std::string& text, Face face, Color with) {
    const float room = row.box.max.x - x - 8 * ui.scale;
    if (room > 8 * ui.scale) {
      x += ui.RowText(list, {x, row.box.min.y}, kRowHeight * ui.scale, text, {face, 12, with},
                      room) +
           8 * ui.scale;
    }
  };
  write(line.name, line.is_asked ? Face::kBold : Face::kSans, ui.palette.text);
  write(StatusOf(line), Face::kBold, ui.palette.TextOf(line.status));
  if (line.is_news) write("new", Face::kSans, ui.palette.accent);
  if (fits) write(line.reason, Face::kSans, ui.palette.text_dim);
}

}  // namespace

void DrawWhy(const Ui& ui, EditorState& state, RunView& run) {
  const bool is_stopped = run.stop().where != DebugStop::Where::kNowhere;
  if (run.is_at_beginning() && !is_stopped) return Hint(ui, "Nothing was ticked yet.");
  state.run.why.Ask(run, SelectedNode(state));
  const WhyAnswer& why = state.run.why;
  const std::string tick = TickText(run.run(), run.playhead().tick());
  if (!why.why_not().empty()) {
    TextRow(ui, "run/why/not", tick + ": " + why.why_not(), {Face::kBold, 12, ui.palette.warning});
  }
  if (!why.change().empty()) {
    TextRow(ui, "run/why/change", why.change(), {Face::kBold, 12, ui.palette.accent});
  }
  if (why.lines().empty() && !why.is_untold() && why.stands().empty())
    Hint(ui, "Nothing was ticked in " + tick + ".");
  for (std::size_t i = 0; i < why.lines().size(); ++i) DrawLine(ui, state, why.lines()[i], i);
  if (why.stands().empty()) return;
  const Row row = TextRow(ui, "run/why/stands", why.stands(), {Face::kBold, 12, ui.palette.text});
  if (row.clicked) SelectRunNode(state, why.stands_at());
}

}  // namespace coppice::editor
