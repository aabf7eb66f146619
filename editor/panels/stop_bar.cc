#include "editor/canvas/free_place.h"
#include "editor/panels/panels.h"
#include "editor/panels/widgets/panel.h"

namespace coppice::editor {
namespace {

struct StopButton {
  const char* path;
  const char* text;
  const char* command;
  Status status;  // that the node is to have; kIdle: its own
};

constexpr StopButton kButtons[] = {
    {"stop/continue", "Continue", "run.continue", Status::kIdle},
    {"stop/step", "Step", "run.step_node", Status::kIdle},
    {"stop/success", "SUCCESS", "run.continue_success", Status::kSuccess},
    {"stop/failure", "FAILURE", "run.continue_failure", Status::kFailure},
    {"stop/skip", "SKIP", "run.continue_skipped", Status::kSkipped}};

constexpr float kBetween = 3;  // pixels between two buttons at scale 1

// Behind a node its result is there already.
bool IsForBoth(const StopButton& button) { return button.status == Status::kIdle; }

float WidthOf(const Ui& ui, const StopButton& button) {
  return ui.Width(button.text, {Face::kSans, 12, 0}) + 16 * ui.scale;
}

float WidthOf(const Ui& ui, bool before) {
  float width = 0;
  for (const StopButton& button : kButtons) {
    if (before || IsForBoth(button)) width += WidthOf(ui, button) + kBetween * ui.scale;
  }
  return width;
}

}  // namespace

void DrawStopBar(const Ui& ui, EditorState& state, const Box& canvas) {
  const RunView* run = state.workspace.run();
  const TreeView* view = state.workspace.view();
  if (!run || !view || !run->playhead().is_at_now()) return;
  const DebugStop& stop = run->stop();
  if (stop.where != DebugStop::Where::kBefore && stop.where != DebugStop::Where::kAfter) return;
  const auto& nodes = view->scene()->of_run_node;
  if (stop.node >= nodes.size() || nodes[stop.node] == kNoSceneNode) return;
  const bool before = stop.where == DebugStop::Where::kBefore;
  const Point size = {WidthOf(ui, before), 22 * ui.scale};
  const Box box =
      FreePlaceBeside(*view, view->ShownOf(nodes[stop.node]), size, 6 * ui.scale, canvas, ui.now);
  ui.items.Add("stop", box);
  // A window of its own: it lies above the canvas, for the mouse too.
  ImGui::SetCursorScreenPos(ToIm(box.min));
  ImGui::BeginChild("stop", ToIm(size), false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoBackground);
  float x = box.min.x;
  for (const StopButton& button : kButtons) {
    if (!before && !IsForBoth(button)) continue;
    const float width = WidthOf(ui, button);
    const Box at = {{x, box.min.y}, {x + width, box.max.y}};
    x += width + kBetween * ui.scale;
    ui.Fill(*ImGui::GetWindowDrawList(), at, ui.palette.panel, 4);
    const Color tint =
        button.status == Status::kIdle ? ui.palette.accent : ui.palette.Of(button.status);
    if (ui.Button(button.path, at, button.text, false, tint)) state.commands.Run(button.command);
    ExplainCommand(ui, state.commands, button.command);
  }
  ImGui::EndChild();
}

}  // namespace coppice::editor
