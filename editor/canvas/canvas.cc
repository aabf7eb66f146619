#include "editor/canvas/canvas.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/canvas_looks.h"
#include "editor/canvas/canvas_mouse.h"
#include "editor/canvas/data_links.h"
#include "editor/canvas/edge_painter.h"
#include "editor/canvas/node_painter.h"
#include "editor/canvas/status_look.h"
#include "editor/canvas/visible_nodes.h"

namespace coppice::editor {
namespace {

constexpr float kEnclosure = 10;  // around a SubTree that is open, at zoom 1

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
    detail_ = DetailFor(camera_.zoom);
    visible_ = FindVisible(view, camera_, box, ui.now);
  }

  void Run() {
    pen_.FillBox(box_, ui_.palette.canvas);
    hovered_ = FindHovered();
    pen_.PushClip(box_);
    if (detail_ == Detail::kFull) DrawGrid();
    if (detail_ != Detail::kBlock) DrawEnclosures();
    for (const VisibleNode& item : visible_) DrawEdge(item);
    for (const VisibleNode& item : visible_) DrawNode(item);
    if (detail_ == Detail::kBlock) DrawLabels();
    PaintDataLinks(pen_, view_, camera_);
    pen_.PopClip();
    if (options_.minimap) DrawMinimap(ui_, view_, box_, options_);
    HandleCanvasMouse(ui_, view_, box_, options_, hovered_);
    pen_.PushClip(box_);
    DrawGesture(pen_, view_, box_, options_);
    pen_.PopClip();
  }

 private:
  const SceneNode& NodeOf(const VisibleNode& item) const {
    return scene_.nodes[view_.shown()[item.k]];
  }

  Box ParentBox(std::uint32_t k) const {
    return camera_.ToScreen(view_.BoxAt(view_.ShownParent(k), ui_.now));
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

  // What belongs to a SubTree lies on a ground of its own.
  void DrawEnclosures() {
    if (view_.IsMoving(ui_.now)) return;
    const float margin = kEnclosure * camera_.zoom;
    for (const VisibleNode& item : visible_) {
      const bool leaf = view_.shown_ends()[item.k] == item.k + 1;
      if (NodeOf(item).shape != Shape::kSubTree || leaf) continue;
      const Box branch = camera_.ToScreen(view_.BranchBounds(item.k));
      const Box box = {branch.min - Point{margin, margin}, branch.max + Point{margin, margin}};
      pen_.FillBox(box, Fade(ui_.palette.text, 0.03F), margin);
      pen_.FrameBox(box, Fade(ui_.palette.text_dim, 0.28F), margin);
    }
  }

  void DrawEdge(const VisibleNode& item) {
    if (item.k == 0 || item.whole_branch) return;
    const SceneNode& node = NodeOf(item);
    EdgeLook look;
    look.parent = ParentBox(item.k);
    look.child = item.box;
    look.child.min.y += NoteHeight(node) * camera_.zoom;
    if (!Union(look.parent, look.child).Overlaps(box_)) return;
    look.link = view_.LinkOf(item.k);
    look.orientation = view_.orientation();
    look.zoom = camera_.zoom;
    look.state = StateOf(options_.live, node);
    look.offline = options_.live && options_.live->connection != Connection::kLive;
    look.number = node.number;
    look.change = ChangeOf(options_, view_.shown()[item.k]);
    if (view_.lit_key() != kNoKey) look.strength = kDimmed;
    if (detail_ == Detail::kBlock) return DrawStraight(look);
    PaintEdge(pen_, look);
  }

  void DrawStraight(const EdgeLook& look) {
    const Color color = StatusColor(ui_.palette, look.state, ui_.palette.edge);
    pen_.Line({ToIm(look.parent.center()), ToIm(look.child.center())},
              Fade(color, 0.7F * look.strength), 1);
  }

  void DrawNode(const VisibleNode& item) {
    if (!item.box.Overlaps(box_)) return;
    const SceneNode& node = NodeOf(item);
    if (item.whole_branch) return DrawBranch(item);
    NodeLook look = LookOf(view_, options_, item.k, item.box, camera_.zoom);
    look.hovered = hovered_ == &item;
    PaintNode(pen_, scene_, node, look);
    Register(item, look);
  }

  // A branch of a few pixels still shows what is wrong in it.
  void DrawBranch(const VisibleNode& item) {
    Color color = ui_.palette.Of(NodeOf(item).shape);
    const std::uint32_t first = view_.shown()[item.k];
    for (std::uint32_t i = first; i < scene_.nodes[first].end; ++i) {
      if (BadgeOf(options_, i) == Badge::kError) color = ui_.palette.error;
      if (StateOf(options_.live, scene_.nodes[i]).status == Status::kRunning) {
        color = ui_.palette.running;
      }
    }
    pen_.FillBox(item.box, color);
  }

  void Register(const VisibleNode& item, const NodeLook& look) {
    const SceneNode& node = NodeOf(item);
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
    for (std::uint32_t i = 0; i < node.port_count; ++i) {
      const PortLine& port = scene_.ports[node.first_port + i];
      if (!port.is_key) continue;
      ui_.items.Add(path + "/port/" + std::string(port.name), PortBox(node, look, i));
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
  const Point size = {box.width(), box.height()};
  if (view.needs_fit) view.FitAll(size);
  CanvasPass(ui, view, box, options).Run();
}

}  // namespace coppice::editor
