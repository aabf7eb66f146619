#include <algorithm>
#include <cstdio>
#include <string>

#include "editor/canvas/free_place.h"
#include "editor/panels/panels.h"
#include "editor/panels/widgets/panel.h"
#include "editor/simulation/chance_text.h"
#include "editor/simulation/script_text.h"
#include "editor/theme/icons.h"
#include "editor/workspace/simulation_editor.h"

namespace coppice::editor {
namespace {

std::string SpeedText(double speed) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", speed);
  return icon::kTimesSign + std::string(text);
}

class Bar {
 public:
  Bar(const Ui& ui, EditorState& state, const Box& box)
      : ui_(ui), state_(state), box_(box), list_(*ImGui::GetWindowDrawList()) {}

  void Draw() {
    ui_.items.Add("sim", box_);
    ui_.Fill(list_, box_, Mix(ui_.palette.panel, ui_.palette.simulation, 0.30F));
    left_ = box_.min.x + 10 * ui_.scale;
    right_ = box_.max.x - 6 * ui_.scale;
    Write("SIMULATION", {Face::kBold, 13, ui_.palette.text}, "sim/banner");
    Right("sim/end", "end", "sim.end");  // has its place in the narrowest bar, too
    DrawLeft();
    DrawRight();
    DrawTime();
  }

 private:
  void DrawLeft() {
    const bool plays = state_.simulator.is_playing();
    Left("sim/restart", icon::kRefresh, "sim.restart");
    Left("sim/back", "back", "sim.back");
    Left("sim/play", plays ? std::string(icon::kPause) + "  pause" : "run", "sim.play", plays);
    Left("sim/tick", "tick", "sim.tick");
    Left("sim/change", std::string(icon::kForward) + "  change", "sim.change");
    left_ += 4 * ui_.scale;
    Left("sim/slower", "-", "sim.slower");
    Write(SpeedText(state_.simulator.speed()), {Face::kSans, 12, ui_.palette.text}, "sim/speed");
    left_ -= 6 * ui_.scale;  // as far from this button as from the other
    Left("sim/faster", "+", "sim.faster");
  }

  void DrawRight() {
    Right("sim/save_test", "as test", "sim.save_test");
    Right("sim/again", "again", "sim.again");
    Right("sim/set", "set key", "sim.set");
    const auto& chance = state_.simulator.get()->chance();
    Right("sim/chance", chance ? "seed " + std::to_string(chance->seed) : "random", "sim.chance",
          chance.has_value());
  }

  void DrawTime() {
    const Simulation& simulation = *state_.simulator.get();
    Duration now = simulation.now();
    std::uint64_t tick = simulation.ticks();
    const RunView& run = *state_.workspace.run();
    if (!run.playhead().is_at_now()) {  // it goes on from what is shown
      const Recording::Tick& shown = run.run().recording().ticks()[run.playhead().tick()];
      now = Simulation::SinceBeginning(shown.start);
      tick = shown.number;
    }
    char seconds[32];
    std::snprintf(seconds, sizeof(seconds), "%.7g s", static_cast<double>(now.count()) * 1e-9);
    std::string result;
    TextStyle style{Face::kSans, 12, ui_.palette.text};
    if (const auto status = state_.simulator.result()) {
      result = std::string("  ") + icon::kRightArrow + " " + ToString(*status);
      style.color = ui_.palette.TextOf(*status);
    }
    left_ += 4 * ui_.scale;
    // The number of the tick is in the timeline, too.
    std::string what = seconds + ("   tick " + std::to_string(tick)) + result;
    if (ui_.Width(what, style) > right_ - left_) what = seconds + result;
    Write(what, style, "sim/time");
  }

  void Write(const std::string& text, const TextStyle& style, const std::string& path) {
    const float room = right_ - left_;
    if (room < 20 * ui_.scale) return;
    const float width = ui_.RowText(list_, {left_, box_.min.y}, box_.height(), text, style, room);
    ui_.items.Add(path, {{left_, box_.min.y}, {left_ + width, box_.max.y}});
    left_ += width + 10 * ui_.scale;
  }

  float WidthOf(const std::string& text) const {
    return ui_.Width(text, {Face::kSans, 12, 0}) + 14 * ui_.scale;
  }

  void Left(const std::string& path, const std::string& text, const char* command,
            bool active = false) {
    const float width = WidthOf(text);
    if (left_ + width > right_) return;
    Press(path, left_, width, text, command, active);
    left_ += width + 4 * ui_.scale;
  }

  void Right(const std::string& path, const std::string& text, const char* command,
             bool active = false) {
    const float width = WidthOf(text);
    if (right_ - width < left_) return;
    right_ -= width;
    Press(path, right_, width, text, command, active);
    right_ -= 4 * ui_.scale;
  }

  void Press(const std::string& path, float x, float width, const std::string& text,
             const char* command, bool active) {
    const Box at = {{x, box_.min.y + 3 * ui_.scale}, {x + width, box_.max.y - 3 * ui_.scale}};
    if (ui_.Button(path, at, text, active, ui_.palette.simulation)) {
      // Not now: what is still to be drawn is of the simulation that the command may end.
      state_.after_frame = [&state = state_, command] { state.commands.Run(command); };
    }
    const EditorCommand* known = state_.commands.Find(command);
    if (!ImGui::IsItemHovered() || !known) return;
    ImGui::SetTooltip("%s   %s", known->title.c_str(), ToString(known->keys).c_str());
  }

  const Ui& ui_;
  EditorState& state_;
  const Box box_;
  ImDrawList& list_;
  float left_ = 0;
  float right_ = 0;
};

struct Answer {
  const char* path;
  const char* text;
  const char* command;
  Status status;
};

constexpr Answer kAnswers[] = {{"sim/success", "SUCCESS", "sim.success", Status::kSuccess},
                               {"sim/failure", "FAILURE", "sim.failure", Status::kFailure},
                               {"sim/running", "RUNNING", "sim.running", Status::kRunning},
                               {"sim/skipped", "SKIPPED", "sim.skipped", Status::kSkipped}};

std::string JoinedLines(const RandomPlay& play) {
  std::string text;
  for (const std::string& line : LinesOf(play)) text += (text.empty() ? "" : "\n") + line;
  return text;
}

// Whose word counts for what happens by chance, in the corner of the canvas.
void DrawOrigin(const Ui& ui, const EditorState& state, const Box& canvas) {
  const auto& chance = state.simulator.get()->chance();
  const std::string origin = chance ? OriginOf(chance->play) : std::string();
  if (origin.empty()) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string text = "random, as " + origin + " says";
  const TextStyle style{Face::kSans, 12, ui.palette.text_dim};
  const float pad = 8 * ui.scale;
  const float height = 22 * ui.scale;
  const Point corner = {canvas.min.x + pad, canvas.max.y - pad - height};
  const Box box = {corner, {corner.x + ui.Width(text, style) + 2 * pad, corner.y + height}};
  ui.Fill(list, box, ui.palette.panel, 5 * ui.scale);
  ui.RowText(list, {corner.x + pad, corner.y}, height, text, style, box.width());
  ui.items.Add("sim/chance_origin", box);
  if (ImGui::IsMouseHoveringRect({box.min.x, box.min.y}, {box.max.x, box.max.y})) {
    Tooltip(ui, JoinedLines(chance->play));
  }
}

}  // namespace

void DrawSimulationBar(const Ui& ui, EditorState& state, const Box& box) {
  Bar(ui, state, box).Draw();
}

void DrawSimulatedLeaf(const Ui& ui, EditorState& state, const Box& canvas) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ui.Frame(list, canvas, ui.palette.simulation, 0, 2 * ui.scale);
  DrawOrigin(ui, state, canvas);
  const TreeView* view = state.workspace.view();
  const NodeIndex leaf = SimulationEditor(state, ui.now).SelectedLeaf();
  if (!view || leaf == kNoNode) return;
  const MockScript& script = *state.simulator.get()->ScriptOf(leaf);
  const std::string does = PrintScript(script);

  const float height = 24 * ui.scale;
  const float pad = 6 * ui.scale;
  const auto width_of = [&](const std::string& text) {
    return ui.Width(text, {Face::kSans, 12, 0}) + 14 * ui.scale;
  };
  float width = width_of(does) + pad;
  for (const Answer& answer : kAnswers) width += width_of(answer.text) + 3 * ui.scale;
  const Box box = FreePlaceBeside(*view, view->ShownOf(view->selected()), {width + pad, height},
                                  pad, canvas, ui.now);
  const Point at = box.min;
  ui.Fill(list, box, ui.palette.panel, 5 * ui.scale);
  ui.Frame(list, box, ui.palette.simulation, 5 * ui.scale);
  float x = at.x + pad / 2;
  const auto button = [&](const char* path, const std::string& text, bool active, Color tint) {
    const Box place = {{x, at.y + 2 * ui.scale},
                       {x + width_of(text), at.y + height - 2 * ui.scale}};
    x = place.max.x + 3 * ui.scale;
    return ui.Button(path, place, text, active, tint);
  };
  for (const Answer& answer : kAnswers) {
    const bool now = script.duration == Duration(0) && script.results.size() == 1 &&
                     script.results[0] == answer.status;
    if (button(answer.path, answer.text, now, ui.palette.Of(answer.status))) {
      state.after_frame = [&state, &answer] { state.commands.Run(answer.command); };
    }
  }
  if (button("sim/script", does, false, 0)) state.commands.Run("sim.script");
}

}  // namespace coppice::editor
