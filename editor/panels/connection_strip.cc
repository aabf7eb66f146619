#include <algorithm>
#include <cmath>
#include <cstdio>

#include "editor/look/icons.h"
#include "editor/panels/panels.h"

namespace coppice::editor {
namespace {

Color StateColor(const Ui& ui, const LiveSnapshot& snapshot) {
  switch (snapshot.connection) {
    case Connection::kLive:
      return ui.palette.success;
    case Connection::kConnecting:
      return ui.palette.accent;
    case Connection::kReconnecting:
      return ui.palette.text_dim;
  }
  return ui.palette.text_dim;
}

std::string Describe(const Ui& ui, const LiveSnapshot& snapshot) {
  char text[96];
  if (snapshot.connection == Connection::kLive) {
    const double milliseconds =
        std::chrono::duration<double, std::milli>(snapshot.round_trip).count();
    std::snprintf(text, sizeof(text), "%.1f Hz   rtt %.1f ms", snapshot.rate, milliseconds);
    return text;
  }
  if (snapshot.connection == Connection::kConnecting) return "connecting";
  const double left = std::chrono::duration<double>(snapshot.next_try - ui.clock).count();
  std::snprintf(text, sizeof(text), "reconnecting (%.0f s)", std::max(0.0, std::ceil(left)));
  return text;
}

// Returns the right end of the tab.
float DrawTab(const Ui& ui, EditorState& state, const Box& bar, float x, std::size_t number) {
  const Robot& robot = state.workspace.robots()[number];
  const bool shown = state.workspace.robot() == &robot;
  const Color color = StateColor(ui, *robot.snapshot);
  const std::string tree =
      robot.tree && robot.tree->forest.main_tree() >= 0
          ? robot.tree->forest.trees()[static_cast<std::size_t>(robot.tree->forest.main_tree())].id
          : "";
  const TextStyle bold{Face::kBold, 12, shown ? ui.palette.text : ui.palette.text_dim};
  const TextStyle plain{Face::kSans, 12, shown ? ui.palette.text : ui.palette.text_dim};
  const std::string about = Describe(ui, *robot.snapshot);
  const float gap = 12 * ui.scale;
  const float width = 26 * ui.scale + ui.Width(robot.source->endpoint(), bold) +
                      (tree.empty() ? 0 : gap + ui.Width(tree, plain)) + gap +
                      std::max(ui.Width(about, plain), 130 * ui.scale) + gap;
  const Box tab = {{x, bar.min.y + 2 * ui.scale}, {x + width, bar.max.y - 2 * ui.scale}};
  bool hovered = false;
  const bool pressed = ui.Hit("strip/" + robot.source->endpoint(), tab, &hovered);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (shown || hovered) {
    ui.Fill(list, tab, Mix(ui.palette.panel, color, shown ? 0.22F : 0.10F), 4);
    if (shown) ui.Frame(list, tab, Mix(ui.palette.panel, color, 0.55F), 4);
  }
  list.AddCircleFilled({tab.min.x + 13 * ui.scale, tab.center().y}, 4.5F * ui.scale, color);
  float at = tab.min.x + 26 * ui.scale;
  at += ui.RowText(list, {at, tab.min.y}, tab.height(), robot.source->endpoint(), bold) + gap;
  if (!tree.empty()) at += ui.RowText(list, {at, tab.min.y}, tab.height(), tree, plain) + gap;
  ui.RowText(list, {at, tab.min.y}, tab.height(), about, plain);
  if (hovered && !robot.snapshot->error.empty()) {
    ImGui::SetTooltip("%s", robot.snapshot->error.c_str());
  }
  if (pressed) state.workspace.ShowRobot(number);
  return tab.max.x + 6 * ui.scale;
}

}  // namespace

void DrawConnectionStrip(const Ui& ui, EditorState& state, const Box& box) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const LiveSnapshot* live = state.workspace.live();
  const Color tint = live ? StateColor(ui, *live) : ui.palette.panel;
  ui.items.Add("strip", box);
  ui.Fill(list, box, Mix(ui.palette.panel, tint, 0.10F));
  ui.Fill(list, {box.min, {box.min.x + 3, box.max.y}}, live ? tint : ui.palette.border);
  float x = box.min.x + 8 * ui.scale;
  for (std::size_t i = 0; i < state.workspace.robots().size(); ++i) {
    x = DrawTab(ui, state, box, x, i);
  }
  if (state.workspace.robots().empty()) {
    x += 6 * ui.scale;
    x += ui.RowText(list, {x, box.min.y}, box.height(), "not connected to a robot",
                    {Face::kSans, 12, ui.palette.text_dim}) +
         14 * ui.scale;
  }
  const std::string text = std::string(icon::kPlug) + "  connect";
  const float width = ui.Width(text, {Face::kSans, 12, 0}) + 20 * ui.scale;
  const Box button = {{x, box.min.y + 4 * ui.scale}, {x + width, box.max.y - 4 * ui.scale}};
  if (ui.Button("strip/connect", button, text)) state.OpenPopup(Popup::kConnect, "127.0.0.1:1667");
}

}  // namespace coppice::editor
