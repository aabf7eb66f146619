#include <vector>

#include "editor/commands/run_commands.h"
#include "editor/panels/run/run_bodies.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

void DrawHook(const Ui& ui, EditorState& state, const RunView& run, const WantedHook& wanted) {
  const std::string path = "run/hook/" + std::to_string(wanted.number);
  Row row = NextRow(ui, path, false);
  ImGui::SetItemAllowOverlap();
  const ImVec2 behind = ImGui::GetCursorScreenPos();
  if (!row.visible) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float right = row.box.max.x - 4 * ui.scale;
  const auto button = [&](const std::string& name, const std::string& text) {
    const float width = ui.Width(text, {Face::kSans, 12, 0}) + 12 * ui.scale;
    const Box at = {{right - width, row.box.min.y + ui.scale}, {right, row.box.max.y - ui.scale}};
    right -= width + 3 * ui.scale;
    return ui.Button(path + name, at, text);
  };
  Hook hook = wanted.hook;
  HookList& hooks = state.workspace.hooks;
  const bool removed = button("/remove", icon::kTimes);
  if (ImGui::IsItemHovered()) Tooltip(ui, "Remove it");
  const bool switched = button("/on", hook.enabled ? "on" : "off");
  if (ImGui::IsItemHovered()) Tooltip(ui, hook.enabled ? "Switch it off" : "Switch it on");
  const bool asked = button("/condition", "if");
  if (ImGui::IsItemHovered()) Tooltip(ui, "When it counts: a condition, a number of hits");
  ImGui::SetCursorScreenPos(behind);

  const SetHookState* set = run.hooks().Find(wanted.number);
  const Color color = !hook.enabled        ? ui.palette.text_dim
                      : IsBreakpoint(hook) ? ui.palette.failure
                                           : ui.palette.warning;
  const Point dot = {row.box.min.x + 12 * ui.scale, row.box.center().y};
  if (set && set->id != kNoHook) {
    list.AddCircleFilled(ToIm(dot), 4 * ui.scale, color);
  } else {
    list.AddCircle(ToIm(dot), 4 * ui.scale, color);
  }
  float x = row.box.min.x + 24 * ui.scale;
  const auto write = [&](const std::string& text, Face face, Color with) {
    const float room = right - x - 4 * ui.scale;
    if (text.empty() || room < 8 * ui.scale) return;
    x += ui.RowText(list, {x, row.box.min.y}, row.box.height(), text, {face, 12, with}, room) +
         8 * ui.scale;
  };
  write(hook.path, Face::kBold, hook.enabled ? ui.palette.text : ui.palette.text_dim);
  const Color writing = !hook.enabled        ? ui.palette.text_dim
                        : IsBreakpoint(hook) ? ui.palette.failure_text
                                             : ui.palette.warning;
  write(ToString(hook), Face::kSans, writing);
  if (set && set->hits > 0) write(Count(set->hits, "hit"), Face::kSans, writing);
  if (!wanted.robot.empty()) write("on " + wanted.robot, Face::kSans, ui.palette.text_dim);
  if (set) write(set->remark, Face::kSans, ui.palette.warning);

  if (removed) return hooks.Remove(wanted.number);
  if (switched) {
    hook.enabled = !hook.enabled;
    return hooks.Change(wanted.number, hook);
  }
  if (asked) AskForCondition(state, wanted.number);
}

}  // namespace

void DrawHooks(const Ui& ui, EditorState& state, RunView& run) {
  const std::vector<WantedHook> all = state.workspace.hooks.all();  // rows may change it
  if (all.empty()) {
    Hint(ui,
         "F9 stops the robot at the selected node; a fault forces its result (Ctrl+P, \"force\"). "
         "Both may be set before the robot is there.");
  }
  for (const WantedHook& wanted : all) DrawHook(ui, state, run, wanted);
}

}  // namespace coppice::editor
