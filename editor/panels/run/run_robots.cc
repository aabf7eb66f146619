#include <algorithm>
#include <string>
#include <vector>

#include "editor/live/run_summary.h"
#include "editor/panels/run/run_bodies.h"
#include "editor/panels/widgets/panel.h"
#include "editor/panels/widgets/run_dot.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

struct Robot {
  std::size_t number;  // of Workspace::runs()
  RunNeed need;
};

// Who needs somebody first, the others as they were connected.
std::vector<Robot> RobotsOf(const Workspace& workspace) {
  std::vector<Robot> robots;
  for (std::size_t i = 0; i < workspace.runs().size(); ++i) {
    const RunView& run = *workspace.runs()[i];
    if (run.source().is_robot()) robots.push_back({i, NeedOf(run)});
  }
  std::stable_sort(robots.begin(), robots.end(),
                   [](const Robot& a, const Robot& b) { return a.need.level > b.need.level; });
  return robots;
}

void DrawRobot(const Ui& ui, const Row& row, const RunView& run, const RunNeed& need) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float gap = 10 * ui.scale;
  const float right = row.box.max.x - gap;
  float x = row.box.min.x + gap;
  DrawRunDot(ui, list, {x, row.box.center().y}, run);
  x += gap;
  const auto write = [&](const std::string& text, const TextStyle& style) {
    if (right - x < gap) return;
    x += ui.RowText(list, {x, row.box.min.y}, row.box.height(), text, style, right - x) + gap;
  };
  write(run.name(), {Face::kBold, 12, ui.palette.text});
  if (run.tree()) write(run.tree()->description()->main_tree, {Face::kSans, 12, ui.palette.text});
  if (need.level == RunNeed::Level::kNone) {
    write(SummaryOf(run), {Face::kSans, 12, ui.palette.text_dim});
    return;
  }
  write(std::string(icon::kWarning) + "  " + need.why,
        {Face::kBold, 12, NeedColor(ui, need.level)});
}

}  // namespace

void DrawRobots(const Ui& ui, EditorState& state, RunView&) {
  const std::vector<Robot> robots = RobotsOf(state.workspace);
  if (robots.empty()) Hint(ui, "No robot is connected. Ctrl+K connects one.");
  for (const Robot& robot : robots) {
    const RunView& run = *state.workspace.runs()[robot.number];
    const bool is_shown = state.workspace.run() == &run;
    const Row row = NextRow(ui, "run/robots/" + run.name(), is_shown);
    if (row.visible) DrawRobot(ui, row, run, robot.need);
    if (row.hovered && !robot.need.why.empty()) Tooltip(ui, robot.need.why);
    if (row.clicked) {
      state.workspace.ShowRun(robot.number);
      return;  // the next frame shows it
    }
  }
}

}  // namespace coppice::editor
