#include <algorithm>

#include "editor/canvas/canvas.h"
#include "editor/canvas/layout/node_metrics.h"
#include "editor/canvas/paint/status_look.h"
#include "editor/commands/menus.h"
#include "editor/panels/drag_source.h"
#include "editor/panels/outline_drop.h"
#include "editor/panels/panels.h"
#include "editor/panels/widgets/panel.h"

namespace coppice::editor {
namespace {

constexpr float kIndent = 12;
constexpr std::uint32_t kDeepest = 12;  // deeper rows are indented no further

std::uint32_t DepthOf(const SceneNode& node) {
  return static_cast<std::uint32_t>(std::count(node.path.begin(), node.path.end(), '.'));
}

class OutlineRow {
 public:
  OutlineRow(const Ui& ui, TreeView& view, const TreeSnapshot* live, std::uint32_t k)
      : ui_(ui),
        view_(view),
        node_number_(view.shown()[k]),
        node_(view.scene()->nodes[node_number_]),
        state_(StateOf(live, node_)),
        live_(live && live->is_fresh) {}

  void Draw(EditorState& state) {
    const Row row = NextRow(ui_, "outline/" + node_.path, view_.IsSelected(node_number_));
    if (!live_ && StartsDrag()) {
      state.drag.carried = Drag{{node_number_}, std::string(node_.name)};
      state.drag.answer = {};
    } else if (row.clicked && !state.drag.carried) {
      Select(state.screen.canvas_size);
    }
    if (row.right_clicked) {
      if (!view_.IsSelected(node_number_)) view_.Select(node_number_);
      OpenMenu(state, menu::kRow, FromIm(ImGui::GetIO().MousePos));
    }
    if (!row.visible) return;
    PaintStatus(row.box);
    PaintText(row.box);
    DropOntoRow(ui_, state, node_number_, row.box);
  }

 private:
  // With Ctrl or Shift more than one, as on the canvas.
  void Select(Point canvas) {
    if (ImGui::GetIO().KeyCtrl) return view_.ToggleSelected(node_number_);
    if (ImGui::GetIO().KeyShift) return view_.SelectTo(node_number_);
    view_.Select(node_number_);
    view_.Reveal(canvas);
  }

  void PaintStatus(const Box& box) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool active = state_.status != Status::kIdle;
    if (!active && state_.before == Status::kIdle) return;
    const Color color = StatusColor(ui_.palette, state_, 0);
    const float strength = !live_ ? 0.4F : active ? 1.0F : 0.45F;
    const bool is_selected = view_.IsSelected(node_number_);  // which must be seen
    if (active && !is_selected) ui_.Fill(list, box, Fade(color, live_ ? 0.12F : 0.05F));
    ui_.Fill(list, {box.min, {box.min.x + 4 * ui_.scale, box.max.y}}, Fade(color, strength));
  }

  void PaintText(const Box& box) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float indent =
        (10 + kIndent * static_cast<float>(std::min(DepthOf(node_), kDeepest))) * ui_.scale;
    const float right = box.max.x - 8 * ui_.scale;
    const std::string note = Note();
    const bool running = state_.status == Status::kRunning;
    const TextStyle note_style{Face::kSans, 11,
                               running && live_ ? ui_.palette.running_text : ui_.palette.text_dim};
    const float note_width = ui_.Width(note, note_style);
    ui_.RowText(list, {right - note_width, box.min.y}, box.height(), note, note_style);

    const Color ink = node_.disabled ? ui_.palette.text_dim : ui_.palette.text;
    const TextStyle glyph{
        Face::kSans, 12,
        node_.disabled ? ink : Mix(ui_.palette.Of(node_.shape), ui_.palette.text, 0.6F)};
    const std::string_view icon = GlyphOf(node_);
    const float middle = box.min.x + indent + 7 * ui_.scale;
    ui_.RowText(list, {middle - ui_.Width(icon, glyph) / 2, box.min.y}, box.height(), icon, glyph);

    const Point at = {box.min.x + indent + 18 * ui_.scale, box.min.y};
    const float room = right - note_width - 6 * ui_.scale - at.x;
    const bool own_name = node_.name != node_.id;
    const float used = ui_.RowText(list, at, box.height(), node_.name,
                                   {own_name ? Face::kBold : Face::kSans, 12, ink}, room);
    if (node_.disabled) {
      const float middle_y = box.center().y;
      ui_.Fill(list, {{at.x, middle_y}, {at.x + used, middle_y + ui_.scale}}, ink);
    }
    const std::string ports = Ports();
    if (room - used > 40 * ui_.scale) {
      ui_.RowText(list, at + Point{used + 7 * ui_.scale, 0}, box.height(), ports,
                  {Face::kSans, 11, ui_.palette.text_dim}, room - used - 7 * ui_.scale);
    }
  }

  std::string Note() const {
    if (view_.IsCollapsed(node_number_)) {
      return std::to_string(node_.end - node_number_ - 1) + " hidden";
    }
    if (state_.status == Status::kRunning) {
      const double seconds = std::chrono::duration<double>(ui_.clock - state_.since).count();
      return DurationText(seconds);
    }
    return StatusGlyph(state_);
  }

  std::string Ports() const {
    std::string text;
    const Scene& scene = *view_.scene();
    for (std::uint32_t i = 0; i < node_.port_count; ++i) {
      const PortLine& port = scene.ports[node_.first_port + i];
      text += (text.empty() ? "" : "  ") + ShownValue(port.value);
    }
    return text;
  }

  const Ui& ui_;
  TreeView& view_;
  const std::uint32_t node_number_;
  const SceneNode& node_;
  const NodeState state_;
  const bool live_;
};

// Scrolls to the selected row when the selection has changed.
void FollowSelection(const Ui& ui, const TreeView& view) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID id = ImGui::GetID("selected");
  const int selected = static_cast<int>(view.selected());
  if (storage.GetInt(id, -1) == selected) return;
  storage.SetInt(id, selected);
  if (view.selected() == kNoSceneNode) return;
  const float height = kRowHeight * ui.scale;
  const float top = static_cast<float>(view.ShownOf(view.selected())) * height;
  const float first = ImGui::GetScrollY();
  const float size = ImGui::GetWindowHeight();
  if (top < first) ImGui::SetScrollY(top);
  if (top + height > first + size) ImGui::SetScrollY(top + height - size);
}

const char* WhyEmpty(const Workspace& workspace) {
  if (workspace.run()) return "The robot's tree, as soon as it has sent it.";
  const OpenFile* file = workspace.file();
  if (!file) return "The nodes of the shown tree. Ctrl+O opens a file.";
  if (!file->forest->trees().empty()) return "The shown tree has no nodes. Tab adds its root.";
  return file->read_problems.empty() ? "The file contains no tree. Ctrl+T makes one."
                                     : "The file cannot be read; PROBLEMS tells why.";
}

}  // namespace

void DrawOutline(const Ui& ui, EditorState& state, const Box& box) {
  TreeView* view = state.workspace.view();
  const TreeSnapshot* live = state.workspace.tree_state();
  const std::string note = !view  ? ""
                           : live ? "status, seconds"
                                  : Count(view->scene()->nodes.size(), "node");
  Panel(ui, "outline", box, "OUTLINE", note, [&] {
    if (!view) {
      return Hint(ui, WhyEmpty(state.workspace));
    }
    FollowSelection(ui, *view);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(view->shown().size()), kRowHeight * ui.scale);
    while (clipper.Step()) {
      const int end = std::min(clipper.DisplayEnd, static_cast<int>(view->shown().size()));
      for (int k = clipper.DisplayStart; k < end; ++k) {
        if (static_cast<std::size_t>(k) >= view->shown().size()) break;  // a row opened or closed
        OutlineRow(ui, *view, live, static_cast<std::uint32_t>(k)).Draw(state);
      }
    }
  });
}

}  // namespace coppice::editor
