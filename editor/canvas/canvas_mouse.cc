#include "editor/canvas/canvas_mouse.h"

#include <algorithm>
#include <optional>

#include "editor/canvas/canvas_looks.h"
#include "editor/canvas/node_tooltip.h"
#include "editor/canvas/paint/node_painter.h"
#include "editor/canvas/wheel.h"

namespace coppice::editor {
namespace {

constexpr float kDragDistance = 4;  // pixels; less is a click

class Mouse {
 public:
  Mouse(const Ui& ui, TreeView& view, const Box& box, const CanvasOptions& options,
        const VisibleNode* hovered)
      : ui_(ui),
        view_(view),
        scene_(*view.scene()),
        box_(box),
        options_(options),
        hovered_(hovered),
        io_(ImGui::GetIO()) {}

  void Handle() {
    ImGui::SetCursorScreenPos(ToIm(box_.min));
    ImGui::SetItemAllowOverlap();
    ImGui::InvisibleButton("canvas", {box_.width(), box_.height()},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    ui_.items.Add("canvas", box_);
    const bool over = ImGui::IsItemHovered();
    if (over && (io_.MouseWheel != 0 || io_.MouseWheelH != 0)) Turn();
    if (ImGui::IsItemActivated()) Press();
    if (ImGui::IsItemActive()) {
      Hold();
    } else if (!ImGui::IsAnyMouseDown()) {
      if (view_.gesture.kind == Gesture::Kind::kPressed && over) Click();
      if (view_.gesture.kind != Gesture::Kind::kDrag) view_.gesture = {};
    }
    const bool idle = !ImGui::IsAnyMouseDown() && view_.gesture.kind == Gesture::Kind::kNone;
    const bool explains = over && hovered_ && idle && options_.tooltips;
    if (explains && HoveredIndex() != options_.unexplained) {
      DrawNodeTooltip(ui_, scene_, HoveredNode(), StateOf(options_.live, HoveredNode()),
                      options_.port_values);
    }
  }

 private:
  std::uint32_t HoveredIndex() const { return view_.shown()[hovered_->k]; }
  const SceneNode& HoveredNode() const { return scene_.nodes[HoveredIndex()]; }

  Point World(const ImVec2& screen) const {
    return view_.camera.ToWorld(FromIm(screen) - box_.min);
  }

  void Turn() {
    const WheelTurn turn{{io_.MouseWheelH, io_.MouseWheel}, io_.KeyCtrl, io_.KeyShift};
    const WheelMove move = MoveOf(turn, options_.wheel_zooms);
    view_.camera.offset = view_.camera.offset + move.pan * ui_.scale;
    if (move.zoom != 1) view_.ZoomAt(FromIm(io_.MousePos) - box_.min, move.zoom);
  }

  void Press() {
    view_.gesture = {};
    view_.gesture.kind = Gesture::Kind::kPressed;
    view_.gesture.start = World(io_.MousePos);
    if (hovered_) view_.gesture.node = HoveredIndex();
  }

  void Hold() {
    Gesture& gesture = view_.gesture;
    if (gesture.kind == Gesture::Kind::kPressed && IsDragging()) Begin();
    if (gesture.kind == Gesture::Kind::kPan) {
      view_.camera.offset = view_.camera.offset + FromIm(io_.MouseDelta);
    }
    const bool escape = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
    if (escape && gesture.kind != Gesture::Kind::kPan) gesture.kind = Gesture::Kind::kCancelled;
  }

  static bool IsDragging() {
    return ImGui::IsMouseDragging(0, kDragDistance) || ImGui::IsMouseDragging(1, kDragDistance) ||
           ImGui::IsMouseDragging(2, kDragDistance);
  }

  // What the button does follows from where it went down and which keys are held.
  void Begin() {
    Gesture& gesture = view_.gesture;
    gesture.kind = Gesture::Kind::kPan;
    if (!ImGui::IsMouseDown(0)) return;
    if (gesture.node != kNoSceneNode && options_.drop && options_.drop->why_not) {
      BeginDrag();
    } else if (io_.KeyShift || io_.KeyCtrl) {
      gesture.kind = Gesture::Kind::kRectangle;
    } else {
      // What was dragged before the pan began counts too.
      const ImVec2 way = ImGui::GetMouseDragDelta(0, kDragDistance);
      view_.camera.offset = view_.camera.offset + FromIm(way) - FromIm(io_.MouseDelta);
    }
  }

  void BeginDrag() {
    Gesture& gesture = view_.gesture;
    gesture.kind = Gesture::Kind::kDrag;
    if (!view_.IsSelected(gesture.node)) view_.Select(gesture.node);
    std::uint32_t end = 0;  // what lies inside another selected branch comes with it
    for (const std::uint32_t node : view_.selection()) {
      if (node < end) continue;
      gesture.drag.nodes.push_back(node);
      end = scene_.nodes[node].end;
    }
    gesture.drag.label = scene_.nodes[gesture.drag.nodes.front()].name;
    const std::size_t more = gesture.drag.nodes.size() - 1;
    if (more > 0) gesture.drag.label += " and " + std::to_string(more) + " more";
  }

  static bool IsClick(int button) {
    const ImVec2 way = ImGui::GetMouseDragDelta(button, kDragDistance);
    return ImGui::IsMouseReleased(button) && way.x == 0 && way.y == 0;
  }

  void OpenMenu() {
    if (!options_.menu) return;
    if (hovered_) return options_.menu(HoveredIndex(), false);
    const DropTarget below = FindDropTarget(view_, World(io_.MousePos), ui_.now);
    const bool is_line = below.place == DropPlace::kEdge && below.node != 0;
    options_.menu(is_line ? below.node : kNoSceneNode, is_line);
  }

  void Click() {
    if (IsClick(1)) return OpenMenu();
    if (!IsClick(0)) return;
    if (!hovered_) {
      view_.LightKey(kNoKey);
      if (!io_.KeyShift && !io_.KeyCtrl) view_.Select(kNoSceneNode);
      return;
    }
    const std::uint32_t node = HoveredIndex();
    if (io_.KeyCtrl) return view_.ToggleSelected(node);
    if (io_.KeyShift) return view_.SelectTo(node);
    const bool twice = io_.MouseClickedLastCount[0] == 2;
    const NodeLook look = LookOf(view_, options_, hovered_->k, hovered_->box, view_.camera.zoom);
    if (!IsOnToggle(look) && (EditPort(look, twice) || ClickKey(look))) return;
    if (twice && !IsOnToggle(look) && options_.open && HoveredNode().shape == Shape::kSubTree) {
      options_.open(node);
    } else if (twice || IsOnToggle(look)) {
      view_.SetCollapsed(node, !look.collapsed, ui_.now);
    } else {
      view_.Select(node);
    }
  }

  bool IsOnToggle(const NodeLook& look) const {
    const bool block = DetailFor(look.zoom, ui_.scale) == Detail::kBlock;
    if (block || !scene_.HasChildren(HoveredIndex())) return false;
    const Point mouse = FromIm(io_.MousePos);
    if (look.collapsed && ChipBox(look).Contains(mouse)) return true;
    return HoveredNode().shape == Shape::kSubTree && ToggleBox(HoveredNode(), look).Contains(mouse);
  }

  // The port, of Scene::ports, whose row lies below the mouse.
  std::optional<std::uint32_t> HoveredPort(const NodeLook& look) const {
    if (look.name_only || DetailFor(look.zoom, ui_.scale) != Detail::kFull) return std::nullopt;
    const SceneNode& node = HoveredNode();
    for (std::uint32_t i = 0; i < node.port_count; ++i) {
      if (PortBox(scene_, node, look, i).Contains(FromIm(io_.MousePos))) return node.first_port + i;
    }
    return std::nullopt;
  }

  bool EditPort(const NodeLook& look, bool twice) {
    const std::optional<std::uint32_t> port = HoveredPort(look);
    if (!twice || !options_.edit_port || !port) return false;
    view_.LightKey(kNoKey);
    options_.edit_port(HoveredIndex(), *port);
    return true;
  }

  // A click on the row of a key lights it; a second one puts it out.
  bool ClickKey(const NodeLook& look) {
    const std::optional<std::uint32_t> port = HoveredPort(look);
    const std::uint32_t key = port ? view_.keys().key_of_port[*port] : kNoKey;
    if (key == kNoKey) return false;
    view_.LightKey(view_.lit_key() == key ? kNoKey : key);
    view_.Select(HoveredIndex());
    return true;
  }

  const Ui& ui_;
  TreeView& view_;
  const Scene& scene_;
  const Box box_;
  const CanvasOptions& options_;
  const VisibleNode* hovered_;
  const ImGuiIO& io_;
};

}  // namespace

void HandleCanvasMouse(const Ui& ui, TreeView& view, const Box& box, const CanvasOptions& options,
                       const VisibleNode* hovered) {
  Mouse(ui, view, box, options, hovered).Handle();
}

}  // namespace coppice::editor
