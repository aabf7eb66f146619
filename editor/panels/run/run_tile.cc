#include "editor/panels/run/run_tile.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "editor/panels/run/run_bodies.h"
#include "editor/panels/widgets/panel.h"

namespace coppice::editor {
namespace {

struct Tab {
  RunTab tab;
  const char* path;
  const char* title;
  void (*draw)(const Ui&, EditorState&, RunView&);
  enum class Of : std::uint8_t {
    kAll,
    kRobots,
    kSeveralRobots,
    kSimulations,
    kPictures
  } of = Of::kAll;

  bool IsFor(const Workspace& workspace) const {
    const RunView* const run = workspace.run();
    const bool is_simulation = run && run->source().is_simulation();
    if (of == Of::kPictures) return run && !run->pictures().empty();
    if (of == Of::kSeveralRobots) return workspace.runs().size() > 1;
    return of == Of::kAll || (of == Of::kSimulations) == is_simulation;
  }
};

constexpr Tab kTabs[] = {
    {RunTab::kWhy, "run/why", "WHY", DrawWhy},
    {RunTab::kRunning, "run/running", "RUNNING", DrawRunning},
    {RunTab::kRobots, "run/robots", "ROBOTS", DrawRobots, Tab::Of::kSeveralRobots},
    {RunTab::kPictures, "run/pictures", "FACE", DrawPictures, Tab::Of::kPictures},
    {RunTab::kHooks, "run/hooks", "BREAKPOINTS", DrawHooks, Tab::Of::kRobots},
    {RunTab::kLog, "run/log", "LOG", DrawLog},
    {RunTab::kStatistics, "run/statistics", "STATISTICS", DrawStatistics},
    {RunTab::kComparison, "run/comparison", "COMPARE", DrawComparison},
    {RunTab::kTable, "run/table", "TABLE", DrawTable},
    {RunTab::kCoverage, "run/coverage", "COVERAGE", DrawCoverage, Tab::Of::kSimulations}};

constexpr float kTabGap = 2;
constexpr float kLeastAround = 4;  // the text of a tab

float TextWidth(const Ui& ui, const Tab& tab) { return ui.Width(tab.title, {Face::kSans, 12, 0}); }

std::vector<const Tab*> ShownTabs(const EditorState& state) {
  std::vector<const Tab*> shown;
  for (const Tab& tab : kTabs) {
    if (tab.IsFor(state.workspace)) shown.push_back(&tab);
  }
  return shown;
}

// Where there are many they stand closer together; what does not fit even then has its key.
void DrawTabs(const Ui& ui, EditorState& state, const Box& box) {
  const float gap = kTabGap * ui.scale;
  const std::vector<const Tab*> shown = ShownTabs(state);
  float room = box.width() - 4 * gap;
  for (const Tab* tab : shown) room -= TextWidth(ui, *tab) + gap;
  const float around =
      std::clamp(room / static_cast<float>(shown.size()), kLeastAround * ui.scale, 12 * ui.scale);
  float x = box.min.x + 2 * gap;
  for (const Tab* tab : shown) {
    const float width = TextWidth(ui, *tab) + around;
    const Box at = {{x, box.min.y + gap}, {x + width, box.min.y + (kPanelHeader - 2) * ui.scale}};
    if (at.max.x > box.max.x) break;
    if (ui.Button(tab->path, at, tab->title, state.run.tab == tab->tab)) state.run.tab = tab->tab;
    x += width + gap;
  }
}

}  // namespace

float RunTabsWidth(const Ui& ui, const EditorState& state) {
  float width = 4 * kTabGap * ui.scale;
  for (const Tab* tab : ShownTabs(state)) {
    width += TextWidth(ui, *tab) + (kTabGap + kLeastAround) * ui.scale;
  }
  return width;
}

void DrawRunTile(const Ui& ui, EditorState& state, const Box& box) {
  RunView* run = state.workspace.run();
  Panel(ui, "run", box, "", "", [&] {
    if (run && state.run.tab == RunTab::kRobots) return DrawRobots(ui, state, *run);
    // Why the robot is not there.
    if (run && !run->connection().problem.empty()) {
      TextRow(ui, "run/problem", run->connection().problem, {Face::kBold, 12, ui.palette.warning});
    }
    if (run && state.run.tab == RunTab::kPictures) return DrawPictures(ui, state, *run);
    const bool is_empty = run && run->run().size() == 0 && state.run.tab != RunTab::kCoverage;
    if (!run || !run->tree() || is_empty) {
      Hint(ui, "Nothing has happened yet: this tile fills as soon as there are ticks.");
      return;
    }
    for (const Tab& tab : kTabs) {
      if (tab.tab == state.run.tab) tab.draw(ui, state, *run);
    }
  });
  DrawTabs(ui, state, box);
}

}  // namespace coppice::editor
