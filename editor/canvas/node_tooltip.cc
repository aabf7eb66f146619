#include "editor/canvas/node_tooltip.h"

#include "editor/live/key_search.h"

namespace coppice::editor {
namespace {

constexpr float kWidth = 340;
constexpr std::size_t kLongestValue = 500;  // bytes

void Line(const Ui& ui, Face face, Color color, const std::string& text) {
  ImGui::PushFont(ui.fonts.For(text, face, 12 * ui.scale));
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

std::string StatusText(const Ui& ui, const NodeState& state) {
  if (state.status == Status::kIdle) {
    if (state.before == Status::kIdle) return "IDLE, never run";
    if (state.before == Status::kRunning) return "IDLE, was halted";
    return std::string("IDLE, was ") + ToString(state.before);
  }
  const double seconds = std::chrono::duration<double>(ui.clock - state.since).count();
  return std::string(ToString(state.status)) + " for " + DurationText(seconds);
}

void Port(const Ui& ui, const PortLine& port, const std::string& now) {
  const std::string line = std::string(port.name) + " = " + BeginningOf(port.value, kLongestValue);
  Line(ui, Face::kMono, ui.palette.text, line);
  if (!now.empty()) Line(ui, Face::kMono, ui.palette.OfKey(port.key), "    = " + now);
  if (!port.model) return;
  std::string about = std::string("    ") + ToString(port.model->direction);
  if (!port.model->type.empty()) about += " " + std::string(TypeText(port.model->type));
  if (!port.model->description.empty()) about += ": " + port.model->description;
  Line(ui, Face::kSans, ui.palette.text_dim, about);
}

}  // namespace

void DrawNodeTooltip(const Ui& ui, const Scene& scene, const SceneNode& node,
                     const NodeState& state, const PortValues* values) {
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(kWidth * ui.scale);
  Line(ui, Face::kBold, ui.palette.text, std::string(node.name));
  const std::string kind = node.model ? ToString(node.model->category) : "unknown type";
  Line(ui, Face::kSans, ui.palette.text_dim,
       std::string(node.id) + "  (" + (node.shape == Shape::kSubTree ? "SubTree" : kind) + ")  " +
           node.path);
  if (node.run_node != kNoNode) {
    const bool idle = state.status == Status::kIdle;
    Line(ui, Face::kSans, idle ? ui.palette.text_dim : ui.palette.Of(state.status),
         StatusText(ui, state));
  }
  if (node.model && !node.model->description.empty()) {
    Line(ui, Face::kSans, ui.palette.text, node.model->description);
  }
  if (!node.note.empty()) Line(ui, Face::kSans, ui.palette.text_dim, node.note);
  for (std::uint32_t i = 0; i < node.port_count; ++i) {
    const std::uint32_t port = node.first_port + i;
    Port(ui, scene.ports[port], values ? values->Of(port) : std::string());
  }
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace coppice::editor
