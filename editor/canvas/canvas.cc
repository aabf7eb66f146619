#include "editor/canvas/canvas.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/edge_painter.h"
#include "editor/canvas/node_painter.h"
#include "editor/canvas/node_tooltip.h"

namespace coppice::editor {
namespace {

constexpr float kWheelStep = 1.15F;
constexpr float kSmallBranch = 3;   // pixels; a smaller branch is one block
constexpr float kDragDistance = 4;  // pixels; less is a click

class CanvasPass {
 public:
  CanvasPass(const Ui& ui, TreeView& view, const Box& box, const CanvasOptions& options)
      : ui_(ui),
        view_(view),
        box_(box),
        options_(options),
        scene_(*view.scene()),
        list_(*ImGui::GetWindowDrawList()) {
    camera_ = view.camera;
    camera_.offset = camera_.offset + box.min;
    detail_ = DetailFor(camera_.zoom);
    offline_ = options.live && options.live->connection != Connection::kLive;
  }

  void Run() {
    ui_.Fill(list_, box_, ui_.palette.canvas);
    Collect();
    hovered_ = FindHovered();
    list_.PushClipRect(ToIm(box_.min), ToIm(box_.max), true);
    DrawGrid();
    for (const Visible& item : visible_) DrawEdge(item);
    for (const Visible& item : visible_) DrawNode(item);
    if (detail_ == Detail::kBlock) DrawLabels();
    list_.PopClipRect();
    if (options_.minimap) DrawMinimap(ui_, view_, box_, options_.live);
    HandleMouse();
  }

 private:
  struct Visible {
    std::uint32_t k;  // of TreeView::shown()
    Box box;
    bool whole_branch;  // too small: one block for all of it
  };

  const SceneNode& NodeOf(const Visible& item) const { return scene_.nodes[view_.shown()[item.k]]; }

  // Skips every branch that is out of sight as a whole.
  void Collect() {
    const bool moving = view_.IsMoving(ui_.now);
    const auto count = static_cast<std::uint32_t>(view_.shown().size());
    for (std::uint32_t k = 0; k < count;) {
      const std::uint32_t end = view_.shown_ends()[k];
      const Box branch = camera_.ToScreen(view_.BranchBounds(k));
      const Box reach = {branch.min - Point{8, 8}, branch.max + Point{8, 8}};
      if (!moving && !reach.Overlaps(box_)) {
        if (k == 0 || !EdgeReaches(k)) {
          k = end;
          continue;
        }
        visible_.push_back({k, camera_.ToScreen(view_.BoxAt(k, ui_.now)), false});
        k = end;
        continue;
      }
      const bool tiny = branch.width() < kSmallBranch && branch.height() < kSmallBranch;
      visible_.push_back({k, tiny ? branch : camera_.ToScreen(view_.BoxAt(k, ui_.now)), tiny});
      k = tiny ? end : k + 1;
    }
  }

  // The line from the parent to a branch that is out of sight may cross the canvas.
  bool EdgeReaches(std::uint32_t k) const {
    const Box child = camera_.ToScreen(view_.BoxAt(k, ui_.now));
    return Union(child, ParentBox(k)).Overlaps(box_);
  }

  Box ParentBox(std::uint32_t k) const {
    const std::uint32_t parent = scene_.nodes[view_.shown()[k]].parent;
    Box box = camera_.ToScreen(view_.BoxAt(view_.ShownOf(parent), ui_.now));
    return box;
  }

  void DrawGrid() {
    if (detail_ != Detail::kFull) return;
    const float step = 40 * camera_.zoom;
    const Color color = Fade(ui_.palette.text_dim, 0.10F);
    const float left = box_.min.x + std::fmod(camera_.offset.x - box_.min.x, step);
    const float top = box_.min.y + std::fmod(camera_.offset.y - box_.min.y, step);
    for (float y = top; y < box_.max.y; y += step) {
      for (float x = left; x < box_.max.x; x += step) {
        list_.AddRectFilled({std::floor(x), std::floor(y)}, {std::floor(x) + 1, std::floor(y) + 1},
                            color);
      }
    }
  }

  void DrawEdge(const Visible& item) {
    const SceneNode& node = NodeOf(item);
    if (item.k == 0 || item.whole_branch) return;
    EdgeLook look;
    look.parent = ParentBox(item.k);
    look.child = item.box;
    if (!Union(look.parent, look.child).Overlaps(box_)) return;
    look.orientation = view_.orientation();
    look.zoom = camera_.zoom;
    look.state = StateOf(options_.live, node);
    look.offline = offline_;
    look.number = node.number;
    if (detail_ == Detail::kBlock) {
      const Color color = StatusColor(ui_.palette, look.state, ui_.palette.edge);
      list_.AddLine(ToIm(look.parent.center()), ToIm(look.child.center()), Fade(color, 0.7F), 1);
      return;
    }
    PaintEdge(ui_, list_, look);
  }

  NodeLook LookOf(const Visible& item) const {
    const std::uint32_t node = view_.shown()[item.k];
    NodeLook look;
    look.box = item.box;
    look.zoom = camera_.zoom;
    look.state = StateOf(options_.live, scene_.nodes[node]);
    look.selected = view_.selected() == node;
    look.hovered = hovered_ == &item;
    look.collapsed = view_.IsCollapsed(node);
    look.offline = offline_;
    if (look.collapsed) RollUp(node, look);
    return look;
  }

  void RollUp(std::uint32_t node, NodeLook& look) const {
    const std::uint32_t end = scene_.nodes[node].end;
    look.hidden = end - node - 1;
    look.hidden_status = look.state.status;
    for (std::uint32_t i = node + 1; i < end; ++i) {
      const Status status = StateOf(options_.live, scene_.nodes[i]).status;
      if (status == Status::kRunning) look.hidden_status = status;
    }
  }

  void DrawNode(const Visible& item) {
    if (!item.box.Overlaps(box_)) return;
    if (item.whole_branch) {
      ui_.Fill(list_, item.box, ui_.palette.Of(NodeOf(item).shape));
      return;
    }
    const NodeLook look = LookOf(item);
    PaintNode(ui_, list_, scene_, NodeOf(item), look);
    const std::string path = "canvas/" + scene_.tree_id + "/" + NodeOf(item).path;
    ui_.items.Add(path, item.box);
    if (HasToggle(item)) {
      ui_.items.Add(path + "/toggle", look.collapsed ? ChipBox(look) : ToggleBox(look));
    }
  }

  bool HasToggle(const Visible& item) const {
    const std::uint32_t node = view_.shown()[item.k];
    if (detail_ == Detail::kBlock || !scene_.HasChildren(node)) return false;
    return view_.IsCollapsed(node) || scene_.nodes[node].shape == Shape::kSubTree;
  }

  // Far away, the names of running nodes stay readable.
  void DrawLabels() {
    for (const Visible& item : visible_) {
      const SceneNode& node = NodeOf(item);
      if (StateOf(options_.live, node).status != Status::kRunning) continue;
      const bool is_leaf = view_.shown_ends()[item.k] == item.k + 1;
      if (!is_leaf) continue;
      const TextStyle style{Face::kBold, 11, ui_.palette.text};
      const float width = ui_.Width(node.name, style);
      const Point at = {item.box.center().x - width / 2, item.box.max.y + 4};
      ui_.Fill(list_, {at - Point{4, 2}, at + Point{width + 4, 15}},
               Mix(ui_.palette.canvas, ui_.palette.running, 0.3F), 3);
      ui_.Text(list_, at, node.name, style);
    }
  }

  const Visible* FindHovered() const {
    const Point mouse = FromIm(ImGui::GetIO().MousePos);
    if (!box_.Contains(mouse)) return nullptr;
    for (const Visible& item : visible_) {
      if (!item.whole_branch && item.box.Contains(mouse)) return &item;
    }
    return nullptr;
  }

  void HandleMouse() {
    ImGui::SetCursorScreenPos(ToIm(box_.min));
    ImGui::SetItemAllowOverlap();
    ImGui::InvisibleButton("canvas", {box_.width(), box_.height()},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    ui_.items.Add("canvas", box_);
    const bool over = ImGui::IsItemHovered();
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive() &&
        (ImGui::IsMouseDragging(0, kDragDistance) || ImGui::IsMouseDragging(1, kDragDistance) ||
         ImGui::IsMouseDragging(2, kDragDistance))) {
      view_.camera.offset = view_.camera.offset + FromIm(io.MouseDelta);
    }
    if (!over) return;
    if (io.MouseWheel != 0) {
      view_.ZoomAt(FromIm(io.MousePos) - box_.min, std::pow(kWheelStep, io.MouseWheel));
    }
    if (ImGui::IsMouseReleased(0) && !WasDragged()) Click();
    if (hovered_ && !ImGui::IsAnyMouseDown()) {
      DrawNodeTooltip(ui_, scene_, NodeOf(*hovered_), StateOf(options_.live, NodeOf(*hovered_)));
    }
  }

  static bool WasDragged() {
    const ImVec2 way = ImGui::GetMouseDragDelta(0, kDragDistance);
    return way.x != 0 || way.y != 0;
  }

  void Click() {
    if (!hovered_) {
      view_.Select(kNoNode);
      return;
    }
    const std::uint32_t node = view_.shown()[hovered_->k];
    const Point mouse = FromIm(ImGui::GetIO().MousePos);
    const NodeLook look = LookOf(*hovered_);
    const Box toggle = look.collapsed ? ChipBox(look) : ToggleBox(look);
    const bool twice = ImGui::GetIO().MouseClickedLastCount[0] == 2;
    if ((HasToggle(*hovered_) && toggle.Contains(mouse)) || twice) {
      view_.SetCollapsed(node, !look.collapsed, ui_.now);
    } else {
      view_.Select(node);
    }
  }

  const Ui& ui_;
  TreeView& view_;
  const Box box_;
  const CanvasOptions& options_;
  const Scene& scene_;
  ImDrawList& list_;
  Camera camera_;
  Detail detail_ = Detail::kFull;
  bool offline_ = false;
  std::vector<Visible> visible_;
  const Visible* hovered_ = nullptr;
};

}  // namespace

NodeState StateOf(const LiveSnapshot* live, const SceneNode& node) {
  if (!live || node.uid < 0 || static_cast<std::size_t>(node.uid) >= live->states.size()) return {};
  return live->states[static_cast<std::size_t>(node.uid)];
}

void DrawCanvas(const Ui& ui, TreeView& view, const Box& box, const CanvasOptions& options) {
  const Point size = {box.width(), box.height()};
  if (view.needs_fit) view.FitAll(size);
  CanvasPass(ui, view, box, options).Run();
}

}  // namespace coppice::editor
