#include <string>
#include <utility>
#include <vector>

#include "editor/commands/run_commands.h"
#include "editor/panels/run/run_bodies.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

// A row with buttons on its right, a dot and texts on its left: buttons come first.
class HookRow {
 public:
  HookRow(const Ui& ui, std::string path)
      : ui_(ui), path_(std::move(path)), row_(NextRow(ui, path_, false)) {
    ImGui::SetItemAllowOverlap();
    behind_ = ImGui::GetCursorScreenPos();
    right_ = row_.box.max.x - 4 * ui_.scale;
    x_ = row_.box.min.x + 24 * ui_.scale;
  }
  ~HookRow() { ImGui::SetCursorScreenPos(behind_); }
  HookRow(const HookRow&) = delete;
  HookRow& operator=(const HookRow&) = delete;

  bool visible() const { return row_.visible; }

  bool Button(const std::string& name, const std::string& text, const char* tip) {
    const float width = ui_.Width(text, {Face::kSans, 12, 0}) + 12 * ui_.scale;
    const Box at = {{right_ - width, row_.box.min.y + ui_.scale},
                    {right_, row_.box.max.y - ui_.scale}};
    right_ -= width + 3 * ui_.scale;
    const bool is_pressed = ui_.Button(path_ + name, at, text);
    if (ImGui::IsItemHovered()) Tooltip(ui_, tip);
    return is_pressed;
  }

  void Dot(Color color, bool is_filled) const {
    const ImVec2 dot = {row_.box.min.x + 12 * ui_.scale, row_.box.center().y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    is_filled ? list.AddCircleFilled(dot, 4 * ui_.scale, color)
              : list.AddCircle(dot, 4 * ui_.scale, color);
  }

  void Write(const std::string& text, Face face, Color color) {
    const float room = right_ - x_ - 4 * ui_.scale;
    if (text.empty() || room < 8 * ui_.scale) return;
    x_ += ui_.RowText(*ImGui::GetWindowDrawList(), {x_, row_.box.min.y}, row_.box.height(), text,
                      {face, 12, color}, room) +
          8 * ui_.scale;
  }

 private:
  const Ui& ui_;
  const std::string path_;
  Row row_;
  ImVec2 behind_;
  float right_ = 0;
  float x_ = 0;
};

// What it does in words, dimmed while it is off.
Color ColorOf(const Ui& ui, const Hook& hook) {
  if (!hook.enabled) return ui.palette.text_dim;
  return IsBreakpoint(hook) ? ui.palette.failure_text : ui.palette.warning;
}

void DrawHook(const Ui& ui, EditorState& state, const RunView& run, const WantedHook& wanted) {
  HookRow row(ui, "run/hook/" + std::to_string(wanted.number));
  if (!row.visible()) return;
  Hook hook = wanted.hook;
  HookList& hooks = state.workspace.hooks;
  const bool removed = row.Button("/remove", icon::kTimes, "Remove it");
  const bool switched = row.Button("/on", hook.enabled ? "on" : "off",
                                   hook.enabled ? "Switch it off" : "Switch it on");
  const bool asked =
      row.Button("/condition", "if", "When it counts: a condition or a number of hits");

  const SetHookState* set = run.hooks().Find(wanted.number);
  const Color writing = ColorOf(ui, hook);
  const bool is_red = hook.enabled && IsBreakpoint(hook);
  row.Dot(is_red ? ui.palette.failure : writing, set && set->id != kNoHook);
  row.Write(hook.path, Face::kBold, hook.enabled ? ui.palette.text : ui.palette.text_dim);
  row.Write(ToString(hook), Face::kSans, writing);
  if (set && set->hits > 0) row.Write(Count(set->hits, "hit"), Face::kSans, writing);
  if (!wanted.robot.empty()) row.Write("on " + wanted.robot, Face::kSans, ui.palette.text_dim);
  if (set) row.Write(set->remark, Face::kSans, ui.palette.warning);

  if (removed) return hooks.Remove(wanted.number);
  if (switched) {
    hook.enabled = !hook.enabled;
    return hooks.Change(wanted.number, hook);
  }
  if (asked) AskForCondition(state, wanted.number);
}

void DrawForeignHook(const Ui& ui, RunView& run, const ForeignHook& foreign) {
  HookRow row(ui, "run/foreign/" + std::to_string(foreign.id));
  if (!row.visible()) return;
  LiveCommand command = MakeCommand(LiveCommand::Kind::kRemoveHook);
  command.id = foreign.id;
  if (row.Button("/remove", icon::kTimes, "Remove it from the robot")) run.Send(command);
  row.Dot(ColorOf(ui, foreign.hook), true);
  row.Write(foreign.hook.path, Face::kBold, ui.palette.text);
  row.Write(ToString(foreign.hook), Face::kSans, ColorOf(ui, foreign.hook));
  row.Write("set by another program", Face::kSans, ui.palette.text_dim);
}

}  // namespace

void DrawHooks(const Ui& ui, EditorState& state, RunView& run) {
  const std::vector<WantedHook> all = state.workspace.hooks.all();  // rows may change it
  const std::vector<ForeignHook> foreign = run.foreign_hooks();
  if (all.empty() && foreign.empty()) {
    Hint(ui,
         "F9 stops the robot at the selected node; a fault forces its result (Ctrl+P, \"force\"). "
         "Both can be set before the robot is connected.");
  }
  for (const WantedHook& wanted : all) DrawHook(ui, state, run, wanted);
  for (const ForeignHook& hook : foreign) DrawForeignHook(ui, run, hook);
}

}  // namespace coppice::editor
