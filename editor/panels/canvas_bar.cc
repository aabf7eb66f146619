#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "editor/commands/menus.h"
#include "editor/panels/panels.h"
#include "editor/panels/widgets/panel.h"
#include "editor/workspace/canvas_tabs.h"

namespace coppice::editor {
namespace {

constexpr float kLongestTab = 150;
constexpr char kSeparator[] = "  /  ";

// A step on the way to the selected node; a click on it selects `node`.
struct Crumb {
  std::string text;
  std::uint32_t node = kNoSceneNode;
};

class CanvasBar {
 public:
  CanvasBar(const Ui& ui, EditorState& state, const Box& box)
      : ui_(ui), state_(state), list_(*ImGui::GetWindowDrawList()), box_(box) {}

  void Draw() {
    UpdateTabs(state_);
    if (!state_.workspace.file() && !state_.workspace.run()) return;  // the start screen has no bar
    list_.AddRectFilled(ToIm(box_.min), ToIm(box_.max), ui_.palette.header, 4 * ui_.scale,
                        ImDrawFlags_RoundCornersTop);
    left_ = box_.min.x + 6 * ui_.scale;
    right_ = box_.max.x - 6 * ui_.scale;
    DrawButtons();
    if (state_.canvas.tabs.size() > 1) DrawTabs();
    DrawCrumbs();
  }

 private:
  // From the right to the left.
  bool Button(const std::string& path, const std::string& text, bool active) {
    const float width = ui_.Width(text, {Face::kSans, 12, 0}) + 16 * ui_.scale;
    const float pad = 3 * ui_.scale;
    const Box at = {{right_ - width, box_.min.y + pad}, {right_, box_.max.y - pad}};
    right_ -= width + 4 * ui_.scale;
    return ui_.Button(path, at, text, active);
  }

  void DrawButtons() {
    const TreeView* view = state_.workspace.view();
    if (!view) return;
    const int percent =
        static_cast<int>(std::lround(view->camera.zoom * 100 / view->screen_scale()));
    const LayoutStyle& style = state_.workspace.style();
    const bool sideways = view->orientation() == Orientation::kLeftToRight;
    const auto button = [this](const char* path, const std::string& text, bool active,
                               const char* command) {
      if (Button(path, text, active)) state_.commands.Run(command);
      ExplainCommand(ui_, state_.commands, command);
    };
    if (state_.workspace.run()) {
      const std::string heat =
          std::string("heat: ") + (state_.run.heat ? ToString(*state_.run.heat) : "off");
      button("canvasbar/heat", heat, state_.run.heat.has_value(), "run.heat");
      button("canvasbar/follow", "follow", state_.run.follow.is_on, "run.follow");
    }
    button("canvasbar/zoom", std::to_string(percent) + " %", false, "view.zoom_100");
    button("canvasbar/fit", "fit", false, "view.fit_all");
    // By itself, then the other way round than it chose, then that.
    const bool by_itself = style.ports == ShownPorts::kByItself;
    const bool shown = by_itself ? !view->names_only() : style.ports == ShownPorts::kAll;
    button("canvasbar/ports", "ports", shown, shown ? "view.ports_none" : "view.ports_all");
    button("canvasbar/compact", "compact", style.compact, "view.compact");
    button("canvasbar/lr", "LR", sideways, "view.left_to_right");
    button("canvasbar/tb", "TB", !sideways, "view.top_to_bottom");
  }

  void DrawTabs() {
    const std::vector<CanvasTab> tabs = state_.canvas.tabs;
    const std::size_t shown = ShownTab(state_);
    const float pad = 3 * ui_.scale;
    for (std::size_t i = 0; i < tabs.size(); ++i) {
      const std::string& name = tabs[i].tree;
      const EditedFile* const file = state_.workspace.project().Find(tabs[i].path);
      const std::string shown_name = (file && file->is_dirty() ? "* " : "") + name;
      const float wanted = ui_.Width(shown_name, {Face::kSans, 12, 0}) + 18 * ui_.scale;
      const float width = std::min(wanted, kLongestTab * ui_.scale);
      if (left_ + width > right_ - 40 * ui_.scale) return;
      const Box at = {{left_, box_.min.y + pad}, {left_ + width, box_.max.y - pad}};
      left_ += width + 4 * ui_.scale;
      const std::string text = ui_.Cut(shown_name, {Face::kSans, 12, 0}, width - 14 * ui_.scale);
      if (ui_.Button("canvasbar/tab/" + name, at, text, i == shown)) {
        ShowTab(state_, i, ui_.now);
      }
      if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(1)) {
        ShowTab(state_, i, ui_.now);
        OpenMenu(state_, menu::kTab, FromIm(ImGui::GetIO().MousePos));
      }
      if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(2)) CloseTab(state_, i, ui_.now);
    }
    left_ += 6 * ui_.scale;
  }

  std::vector<Crumb> Crumbs() const {
    const Workspace& workspace = state_.workspace;
    std::string name;
    if (const OpenFile* file = workspace.file()) {
      const EditedFile* const edited = workspace.project().Find(file->path);
      const bool is_dirty = edited && edited->is_dirty();
      name = (is_dirty ? "* " : "") + file->path.substr(file->path.rfind('/') + 1);
    }
    if (const RunView* run = workspace.run()) {
      name = run->name();
      if (!run->source().is_robot()) name = name.substr(name.rfind('/') + 1);
    }
    std::vector<Crumb> crumbs = {{name, kNoSceneNode}};
    const TreeView* view = state_.workspace.view();
    if (!view) return crumbs;
    crumbs.push_back({view->scene()->tree_id, 0});
    const auto& nodes = view->scene()->nodes;
    std::vector<Crumb> inner;
    for (std::uint32_t i = view->selected(); i != kNoSceneNode; i = nodes[i].parent) {
      if (i != view->selected() && nodes[i].shape != Shape::kSubTree) continue;
      inner.push_back({std::string(nodes[i].name), i});
    }
    crumbs.insert(crumbs.end(), inner.rbegin(), inner.rend());
    return crumbs;
  }

  void DrawCrumbs() {
    const std::vector<Crumb> crumbs = Crumbs();
    const TextStyle dim{Face::kSans, 12, ui_.palette.text_dim};
    float x = left_ + 4 * ui_.scale;
    for (std::size_t i = 0; i < crumbs.size(); ++i) {
      const float room = right_ - x - 4 * ui_.scale;
      if (room < 12 * ui_.scale) return;
      if (i > 0) x += ui_.RowText(list_, {x, box_.min.y}, box_.height(), kSeparator, dim, room);
      const TextStyle style{Face::kSans, 12, ui_.palette.text};
      const float width = std::min(ui_.Width(crumbs[i].text, style), right_ - x - 4 * ui_.scale);
      if (width <= 0) return;
      DrawCrumb(crumbs[i], {{x, box_.min.y}, {x + width, box_.max.y}}, i);
      x += width;
    }
  }

  void DrawCrumb(const Crumb& crumb, const Box& at, std::size_t number) {
    bool hovered = false;
    const bool can = crumb.node != kNoSceneNode;
    const std::string path = "canvasbar/crumb/" + std::to_string(number);
    if (can && ui_.Hit(path, at, &hovered)) {
      TreeView& view = *state_.workspace.view();
      view.Select(crumb.node);
      view.Reveal(state_.screen.canvas_size);
    }
    const TextStyle style{Face::kSans, 12, hovered ? ui_.palette.accent : ui_.palette.text};
    ui_.RowText(list_, at.min, at.height(), crumb.text, style, at.width() + 1);
  }

  const Ui& ui_;
  EditorState& state_;
  ImDrawList& list_;
  const Box box_;
  float left_ = 0;
  float right_ = 0;
};

}  // namespace

void DrawCanvasBar(const Ui& ui, EditorState& state, const Box& box) {
  CanvasBar(ui, state, box).Draw();
}

}  // namespace coppice::editor
