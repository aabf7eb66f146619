#include "editor/panels/canvas_tile.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "editor/canvas/canvas.h"
#include "editor/canvas/layout/node_metrics.h"
#include "editor/canvas/paint/node_marks.h"
#include "editor/commands/difference_commands.h"
#include "editor/commands/menus.h"
#include "editor/document/shown_problems.h"
#include "editor/panels/widgets/difference_list.h"
#include "editor/panels/widgets/port_editor.h"
#include "editor/scene/problem_places.h"
#include "editor/workspace/node_drop.h"
#include "editor/workspace/tree_editor.h"

namespace coppice::editor {
namespace {

constexpr float kBanner = 28;
constexpr float kDifferences = 300;

bool AreSame(const std::vector<Diagnostic>& a, const std::vector<Diagnostic>& b) {
  const auto key = [](const Diagnostic& one) {
    return std::tie(one.severity, one.where.file, one.where.line, one.where.column);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const Diagnostic& x, const Diagnostic& y) { return key(x) == key(y); });
}

class CanvasTile {
 public:
  CanvasTile(const Ui& ui, EditorState& state, const Box& box)
      : ui_(ui), state_(state), view_(*state.workspace.view()), box_(box) {}

  void Draw() {
    if (state_.canvas.comparison) return DrawComparison();
    UpdateBadges();
    CanvasOptions options;
    options.minimap = state_.screen.tiles.minimap;
    options.wheel_zooms = state_.screen.wheel_zooms;
    // Who types looks at the tree; who steps through a run, at values beside the mouse.
    options.tooltips = !state_.input.by_keys || state_.workspace.run();
    options.unexplained = NodeWithButtons();
    if (const Box* label = ui_.items.Find("sim/chance_origin")) options.occupied = *label;
    options.live = state_.workspace.tree_state();
    if (const RunView* const run = state_.workspace.run()) {
      state_.canvas.port_values.Look(*run, view_.scene());
      options.port_values = &state_.canvas.port_values;
    }
    options.badges = &state_.canvas.badges.by_node;
    const NodeDrop drop(state_, ui_.now);
    if (TreeEditor(state_, ui_.now).CanEdit()) options.drop = &drop.handler();
    if (state_.workspace.file()) {
      options.open = [this](std::uint32_t) {
        state_.after_frame = [&s = state_] { s.commands.Run("tree.definition"); };
      };
    }
    const HeatMap heat = RunHeat(state_, view_);
    if (!heat.values.empty()) options.heat = &heat;
    const std::vector<Change> changes = RunDifferences(state_, view_);
    if (!changes.empty()) options.changes = &changes;
    if (options.drop) {
      options.edit_port = [this](std::uint32_t node, std::uint32_t port) {
        view_.Select(node);
        EditPort(state_, std::string(view_.scene()->ports[port].name));
      };
    }
    options.menu = [this](std::uint32_t node, bool is_line) { OpenMenuOf(node, is_line); };
    DrawCanvas(ui_, view_, box_, options);
    DrawPortEditor(ui_, state_, box_);
    if (!options.live) return;
    FollowRunning(state_.run.follow, view_, *options.live, {box_.width(), box_.height()}, ui_.now);
  }

 private:
  // A tooltip would lie over what one wants to click.
  std::uint32_t NodeWithButtons() const {
    if (ui_.items.Find("sim/success")) return view_.selected();
    return ui_.items.Find("stop") ? view_.scene()->of_run_node[state_.workspace.run()->stop().node]
                                  : kNoSceneNode;
  }

  // What the menu is about is selected; of several nodes that are, all.
  void OpenMenuOf(std::uint32_t node, bool is_line) {
    if (node == kNoSceneNode || !view_.IsSelected(node)) view_.Select(node);
    const char* const name = node == kNoSceneNode ? menu::kCanvas
                             : is_line            ? menu::kLine
                                                  : menu::kNode;
    OpenMenu(state_, name, FromIm(ImGui::GetIO().MousePos));
  }

  void UpdateBadges() {
    CanvasBadges& badges = state_.canvas.badges;
    const OpenFile* file = state_.workspace.file();
    const Forest* forest = state_.workspace.forest();
    static const std::vector<Diagnostic> kNone;
    const std::vector<Diagnostic>& problems = file ? file->problems : kNone;
    if (badges.scene == view_.scene() && AreSame(badges.problems, problems)) return;
    badges.scene = view_.scene();
    badges.problems = problems;
    badges.by_node.clear();
    if (!forest) return;
    std::vector<Diagnostic> of_nodes;
    std::remove_copy_if(problems.begin(), problems.end(), std::back_inserter(of_nodes),
                        IsAboutModels);
    for (const std::uint8_t worst : PlaceProblems(*forest, *view_.scene(), of_nodes)) {
      badges.by_node.push_back(static_cast<Badge>(worst));
    }
  }

  Comparison::Alive Alive() const {
    if (const OpenFile* file = state_.workspace.file()) return {file->forest, file->models};
    const RunView* run = state_.workspace.run();
    return run ? Comparison::Alive{run->tree()} : Comparison::Alive{};
  }

  void DrawComparison() {
    Comparison& comparison = *state_.canvas.comparison;
    comparison.Follow(
        view_.scene(), Alive(), view_.style(),
        [this](const Scene& scene, const SceneNode& node) {
          return MeasureNode(ui_, scene, node, false);
        },
        ui_.now);
    const Box banner = {box_.min, {box_.max.x, box_.min.y + kBanner * ui_.scale}};
    CanvasOptions options;
    options.minimap = state_.screen.tiles.minimap;
    options.wheel_zooms = state_.screen.wheel_zooms;
    options.changes = &comparison.changes();
    const bool has_list = !comparison.differences().empty();
    const float list = has_list ? std::min(kDifferences * ui_.scale, box_.width() / 3) : 0;
    const float right = box_.max.x - list;
    if (!comparison.view().scene()->nodes.empty()) {
      const Box canvas = {{box_.min.x, banner.max.y}, {right, box_.max.y}};
      state_.screen.canvas_size = {canvas.width(), canvas.height()};
      DrawCanvas(ui_, comparison.view(), canvas, options);
    }
    if (has_list) {
      DrawDifferenceList(ui_, state_, comparison, {{right, banner.max.y}, box_.max});
    }
    DrawBanner(comparison, banner);
  }

  struct LegendEntry {
    const char* text;
    Change change;
  };
  static constexpr LegendEntry kLegend[] = {{"+ added", Change::kAdded},
                                            {"\u2013 removed", Change::kRemoved},
                                            {"\u2192 moved", Change::kMoved},
                                            {"~ changed", Change::kChanged}};
  static constexpr float kLegendGap = 12;

  TextStyle LegendStyle(Change change) const {
    return {Face::kSans, 11, Mix(ColorOf(ui_.palette, change), ui_.palette.text, 0.6F)};
  }

  float LegendWidth() const {
    float width = 0;
    for (const LegendEntry& entry : kLegend) {
      width += ui_.Width(entry.text, LegendStyle(entry.change)) + kLegendGap * ui_.scale;
    }
    return width;
  }

  void DrawLegend(ImDrawList& list, float x, const Box& banner) const {
    for (const LegendEntry& entry : kLegend) {
      x += ui_.RowText(list, {x, banner.min.y}, banner.height(), entry.text,
                       LegendStyle(entry.change)) +
           kLegendGap * ui_.scale;
    }
  }

  void DrawBanner(const Comparison& comparison, const Box& banner) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ui_.Fill(list, banner, Mix(ui_.palette.panel, ui_.palette.accent, 0.25F));
    const float width = 70 * ui_.scale;
    const float pad = 4 * ui_.scale;
    const Box close = {{banner.max.x - width - pad, banner.min.y + pad},
                       {banner.max.x - pad, banner.max.y - pad}};
    const float end =
        comparison.differences().empty()
            ? close.min.x
            : DrawDifferenceButtons(ui_, state_, close.min - Point{pad, 0}, close.height());
    const float legend = end - 16 * ui_.scale - LegendWidth();
    const std::string& path = comparison.path();
    const std::string text =
        "compared with " + path.substr(path.rfind('/') + 1) + ": " + comparison.summary();
    const TextStyle style{Face::kSans, 12, ui_.palette.text};
    const float left = banner.min.x + 10 * ui_.scale;
    const bool both_fit = left + ui_.Width(text, style) + 16 * ui_.scale < legend;
    const float right = both_fit ? legend : end - 16 * ui_.scale;
    ui_.RowText(list, {left, banner.min.y}, banner.height(), text, style, right - left);
    if (both_fit) DrawLegend(list, legend, banner);
    if (ui_.Button("comparison/close", close, "close")) state_.canvas.comparison.reset();
  }

  const Ui& ui_;
  EditorState& state_;
  TreeView& view_;
  const Box box_;
};

}  // namespace

HeatMap RunHeat(EditorState& state, const TreeView& view) {
  const RunView* run = state.workspace.run();
  if (!run || !state.run.heat) return {};
  if (run->source().is_simulation() && state.run.tab == RunTab::kCoverage && run->tree() &&
      state.coverage.coverage()) {
    return state.coverage.Heat(*state.run.heat, *run->tree()->description(), *view.scene());
  }
  if (run->run().size() == 0) return {};
  state.run.figures.Update(run->run(), state.run.timelines[run->name()].range);
  return state.run.figures.Heat(*state.run.heat, *run->tree()->description(), *view.scene());
}

std::vector<Change> RunDifferences(const EditorState& state, const TreeView& view) {
  const RunComparison* const shown = ShownRunComparison(state);
  if (!shown) return {};
  std::vector<Change> changes(view.scene()->nodes.size(), Change::kNone);
  const auto& nodes = state.workspace.run()->tree()->description()->nodes;
  const auto& in_scene = view.scene()->of_run_node;
  for (const RunDifference& difference : shown->differences) {
    for (std::size_t i = 0; i < nodes.size() && i < in_scene.size(); ++i) {
      if (in_scene[i] != kNoSceneNode && nodes[i].path == difference.what) {
        changes[in_scene[i]] = Change::kChanged;
      }
    }
  }
  return changes;
}

void DrawCanvasTile(const Ui& ui, EditorState& state, const Box& box) {
  CanvasTile(ui, state, box).Draw();
}

}  // namespace coppice::editor
