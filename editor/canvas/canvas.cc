#include "editor/canvas/canvas.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "editor/canvas/canvas_mouse.h"
#include "editor/canvas/data_links.h"
#include "editor/canvas/paint/node_painter.h"
#include "editor/canvas/tree_painter.h"
#include "editor/canvas/visible_nodes.h"

namespace coppice::editor {
namespace {

class CanvasPass {
 public:
  CanvasPass(const Ui& ui, TreeView& view, const Box& box, const CanvasOptions& options)
      : ui_(ui),
        view_(view),
        box_(box),
        options_(options),
        scene_(*view.scene()),
        pen_(ui, *ImGui::GetWindowDrawList()) {
    camera_ = view.camera;
    camera_.offset = camera_.offset + box.min;
    detail_ = DetailFor(camera_.zoom, ui.scale);
    visible_ = FindVisible(view, camera_, box, ui.now);
  }

  void Run() {
    pen_.FillBox(box_, ui_.palette.canvas);
    hovered_ = FindHovered();
    pen_.PushClip(box_);
    if (detail_ == Detail::kFull) DrawGrid();
    PaintTree(pen_, {view_, options_, camera_, box_, visible_, hovered_});
    for (const VisibleNode& item : visible_) Register(item);
    if (detail_ == Detail::kBlock) DrawLabels();
    PaintDataLinks(pen_, view_, camera_);
    pen_.PopClip();
    if (options_.minimap) DrawMinimap(ui_, view_, box_, visible_, options_);
    HandleCanvasMouse(ui_, view_, box_, options_, hovered_);
    pen_.PushClip(box_);
    DrawGesture(pen_, view_, box_, options_);
    pen_.PopClip();
  }

 private:
  const SceneNode& NodeOf(const VisibleNode& item) const {
    return scene_.nodes[view_.shown()[item.k]];
  }

  void DrawGrid() {
    const float step = 40 * camera_.zoom;
    const Color color = Fade(ui_.palette.text_dim, 0.10F);
    const float left = box_.min.x + std::fmod(camera_.offset.x - box_.min.x, step);
    const float top = box_.min.y + std::fmod(camera_.offset.y - box_.min.y, step);
    for (float y = top; y < box_.max.y; y += step) {
      for (float x = left; x < box_.max.x; x += step) {
        const Point at = {std::floor(x), std::floor(y)};
        pen_.FillBox({at, at + Point{1, 1}}, color);
      }
    }
  }

  void Register(const VisibleNode& item) {
    if (item.whole_branch || !item.box.Overlaps(box_)) return;
    const SceneNode& node = NodeOf(item);
    NodeLook look;
    look.box = item.box;
    look.zoom = camera_.zoom;
    look.collapsed = view_.IsCollapsed(view_.shown()[item.k]);
    const std::string path = "canvas/" + scene_.tree_id + "/" + node.path;
    ui_.items.Add(path, BodyBox(node, look));
    if (detail_ != Detail::kBlock && scene_.HasChildren(view_.shown()[item.k])) {
      if (look.collapsed) ui_.items.Add(path + "/toggle", ChipBox(look));
      if (!look.collapsed && node.shape == Shape::kSubTree) {
        ui_.items.Add(path + "/toggle", ToggleBox(node, look));
      }
    }
    if (detail_ != Detail::kFull) return;
    if (!node.note.empty()) ui_.items.Add(path + "/note", look.box);
    if (view_.names_only()) return;
    for (std::uint32_t i = 0; i < node.port_count; ++i) {
      const PortLine& port = scene_.ports[node.first_port + i];
      ui_.items.Add(path + "/port/" + std::string(port.name), PortBox(scene_, node, look, i));
    }
  }

  // Far away, the names of running nodes stay readable.
  void DrawLabels() {
    for (const VisibleNode& item : visible_) {
      const SceneNode& node = NodeOf(item);
      if (StateOf(options_.live, node).status != Status::kRunning) continue;
      const bool is_leaf = view_.shown_ends()[item.k] == item.k + 1;
      if (!is_leaf) continue;
      const TextStyle style{Face::kBold, 11, ui_.palette.text};
      const float width = ui_.Width(node.name, style);
      const Point at = {item.box.center().x - width / 2, item.box.max.y + 4};
      pen_.FillBox({at - Point{4, 2}, at + Point{width + 4, 15 * ui_.scale}},
                   Mix(ui_.palette.canvas, ui_.palette.running, 0.3F), 3);
      pen_.Text(at, node.name, style);
    }
  }

  const VisibleNode* FindHovered() const {
    const Point mouse = FromIm(ImGui::GetIO().MousePos);
    if (!box_.Contains(mouse)) return nullptr;
    for (const VisibleNode& item : visible_) {
      if (!item.whole_branch && item.box.Contains(mouse)) return &item;
    }
    return nullptr;
  }

  const Ui& ui_;
  TreeView& view_;
  const Box box_;
  const CanvasOptions& options_;
  const Scene& scene_;
  ScreenPen pen_;
  Camera camera_;
  Detail detail_ = Detail::kFull;
  std::vector<VisibleNode> visible_;
  const VisibleNode* hovered_ = nullptr;
};

}  // namespace

void DrawCanvas(const Ui& ui, TreeView& view, const Box& box, const CanvasOptions& options) {
  view.SetScreenScale(ui.scale);
  const Point mouse = FromIm(ImGui::GetIO().MousePos);
  const bool is_over =
      box.Contains(mouse) && ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  view.mouse = is_over ? std::optional(mouse) : std::nullopt;
  view.PlaceIn(box);
  CanvasPass(ui, view, box, options).Run();
}

}  // namespace coppice::editor
