#include "editor/canvas/canvas.h"
#include "editor/canvas/node_metrics.h"
#include "editor/panels/panel.h"
#include "editor/panels/panels.h"

namespace coppice::editor {
namespace {

constexpr float kLabelWidth = 92;

class Inspector {
 public:
  Inspector(const Ui& ui, EditorState& state, const SceneNode& node)
      : ui_(ui), state_(state), scene_(*state.workspace.view()->scene()), node_(node) {}

  void Draw() {
    ImGui::SetCursorPosY(4 * ui_.scale);
    Field("name", std::string(node_.name), ui_.palette.text);
    Field("type", std::string(node_.id) + "  (" + Category() + ")", ui_.palette.text);
    Field("path", node_.path, ui_.palette.text);
    DrawStatus();
    const SourceLocation where = Where();
    if (where.line > 0) {
      Field("source",
            where.file.substr(where.file.rfind('/') + 1) + ":" + std::to_string(where.line),
            ui_.palette.text);
    }
    if (node_.model && !node_.model->source.empty()) {
      Field("model", node_.model->source.substr(node_.model->source.rfind('/') + 1),
            ui_.palette.text);
    }
    if (node_.scope < scene_.scopes.size()) {
      Field("blackboard", scene_.scopes[node_.scope], ui_.palette.text);
    }
    DrawPorts();
    if (node_.model && !node_.model->description.empty()) Hint(ui_, node_.model->description);
    if (!node_.model && node_.shape == Shape::kUnknown) {
      Hint(ui_,
           "No model of this type is known. Give one with --models, in <TreeNodesModel>, or "
           "connect to the robot.");
    }
  }

 private:
  std::string Category() const {
    if (node_.shape == Shape::kSubTree) return "SubTree";
    return node_.model ? ToString(node_.model->category) : "unknown";
  }

  SourceLocation Where() const {
    const Document& document = *state_.workspace.forest()->documents()[node_.document];
    return document.Location(document.element(node_.element).offset);
  }

  void DrawStatus() {
    if (node_.uid < 0 || !state_.workspace.live()) return;
    const NodeState state = StateOf(state_.workspace.live(), node_);
    if (state.status == Status::kIdle) {
      const std::string was = state.before == Status::kIdle
                                  ? "IDLE, never run"
                                  : std::string("IDLE, was ") + ToString(state.before);
      Field("status", was, ui_.palette.text_dim);
      return;
    }
    const double seconds = std::chrono::duration<double>(ui_.clock - state.since).count();
    Field("status", std::string(ToString(state.status)) + "  " + DurationText(seconds),
          ui_.palette.Of(state.status));
  }

  void Field(std::string_view label, std::string_view value, Color color, Face face = Face::kSans) {
    const Row row = NextRow(ui_, "inspector/" + std::string(label), false, 24);
    if (row.visible) Paint(row, label, value, color, face);
    if (row.hovered) ImGui::SetTooltip("%.*s", static_cast<int>(value.size()), value.data());
  }

  void Paint(const Row& row, std::string_view label, std::string_view value, Color color,
             Face face) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = 8 * ui_.scale;
    ui_.RowText(list, row.box.min + Point{pad, 0}, row.box.height(), label,
                {Face::kSans, 11, ui_.palette.text_dim}, (kLabelWidth - 8) * ui_.scale);
    const Box field = {row.box.min + Point{pad + kLabelWidth * ui_.scale, 2 * ui_.scale},
                       row.box.max - Point{pad, 2 * ui_.scale}};
    ui_.Fill(list, field, ui_.palette.field, 3);
    ui_.RowText(list, field.min + Point{6 * ui_.scale, 0}, field.height(), value,
                {face, face == Face::kMono ? 11.0F : 12.0F, color}, field.width() - 12 * ui_.scale);
  }

  void Heading(std::string_view text) {
    const Row row = NextRow(ui_, "inspector/heading/" + std::string(text), false, 22);
    ui_.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{8 * ui_.scale, 0},
                row.box.height(), text, {Face::kBold, 11, ui_.palette.text_dim});
  }

  void DrawPorts() {
    if (node_.port_count > 0) Heading("ports");
    for (std::uint32_t i = 0; i < node_.port_count; ++i) {
      DrawPort(scene_.ports[node_.first_port + i]);
    }
    if (!node_.model || node_.shape == Shape::kSubTree) return;
    for (const PortModel& port : node_.model->ports) {
      if (!IsGiven(port.name)) DrawMissing(port);
    }
  }

  bool IsGiven(const std::string& name) const {
    for (std::uint32_t i = 0; i < node_.port_count; ++i) {
      if (scene_.ports[node_.first_port + i].name == name) return true;
    }
    return false;
  }

  void DrawPort(const PortLine& port) {
    const Row row = NextRow(ui_, "inspector/port/" + std::string(port.name), false, 24);
    const Color color = port.is_key ? ui_.palette.OfKey(KeyOf(port.value)) : ui_.palette.text;
    if (row.visible) Paint(row, port.name, port.value, color, Face::kMono);
    if (row.hovered) PortTooltip(port.model, port.value);
  }

  void DrawMissing(const PortModel& port) {
    const Row row = NextRow(ui_, "inspector/port/" + port.name, false, 24);
    const std::string value = port.default_text ? *port.default_text : "(not given)";
    if (row.visible) Paint(row, port.name, value, Fade(ui_.palette.text_dim, 0.7F), Face::kMono);
    if (row.hovered) PortTooltip(&port, value);
  }

  void PortTooltip(const PortModel* model, std::string_view value) {
    std::string text(value);
    if (model) {
      text += std::string("\n") + ToString(model->direction) + " " + model->type;
      if (!model->description.empty()) text += "\n" + model->description;
    }
    ImGui::SetTooltip("%s", text.c_str());
  }

  const Ui& ui_;
  EditorState& state_;
  const Scene& scene_;
  const SceneNode& node_;
};

}  // namespace

void DrawInspector(const Ui& ui, EditorState& state, const Box& box) {
  const TreeView* view = state.workspace.view();
  const bool has = view && view->selected() != kNoNode;
  const std::string note = has ? std::string(view->scene()->nodes[view->selected()].name) : "";
  Panel(ui, "inspector", box, "INSPECTOR", note, [&] {
    if (!has) {
      Hint(ui, "Click a node, or walk with the arrow keys.");
      return;
    }
    Inspector(ui, state, view->scene()->nodes[view->selected()]).Draw();
  });
}

}  // namespace coppice::editor
