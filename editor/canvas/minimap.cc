#include <algorithm>

#include "editor/canvas/canvas_looks.h"
#include "editor/canvas/paint/status_look.h"

namespace coppice::editor {
namespace {

constexpr float kWidth = 178;
constexpr float kHeight = 104;
constexpr float kInset = 8;
constexpr float kMargin = 10;       // from the edges of the canvas
constexpr float kClearance = 6;     // from nodes: their badges and frames stand out
constexpr float kCovering = 0.55F;  // opacity of its ground where it lies over nodes
constexpr float kPart = 4.5F;       // of the canvas' width at most one in so many,
constexpr float kLeast = 0.6F;      // but not smaller than this part of its full size
constexpr float kInSight = 0.98F;   // of the tree's area
constexpr float kSmallest = 2;      // pixels; a smaller branch is one block
constexpr float kFarZoom = 0.01F;   // from there on nodes are far smaller than a pixel:
constexpr float kFarBranch = 16;    // larger branches are one block

Color ColorOf(const Ui& ui, const CanvasOptions& options, const Scene& scene, std::uint32_t node) {
  const SceneNode& shown = scene.nodes[node];
  if (BadgeOf(options, node) == Badge::kError) return ui.palette.error;
  if (options.heat && node < options.heat->values.size()) {
    const float heat = options.heat->values[node];
    return heat < 0 ? ui.palette.node_border : HeatColor(ui.palette, heat);
  }
  return StatusColor(ui.palette, StateOf(options.live, shown), ui.palette.Of(shown.shape));
}

// Almost all of the tree is in sight: there is nothing that it could show.
bool IsAllInSight(const TreeView& view, const Box& canvas) {
  Camera camera = view.camera;
  camera.offset = camera.offset + canvas.min;
  const Box all = camera.ToScreen(view.bounds());
  const Box seen = {{std::max(all.min.x, canvas.min.x), std::max(all.min.y, canvas.min.y)},
                    {std::min(all.max.x, canvas.max.x), std::min(all.max.y, canvas.max.y)}};
  if (seen.width() <= 0 || seen.height() <= 0) return false;
  return seen.width() * seen.height() >= kInSight * all.width() * all.height();
}

class Minimap {
 public:
  Minimap(const Ui& ui, TreeView& view, const Box& box, const std::vector<VisibleNode>& nodes,
          const CanvasOptions& options)
      : ui_(ui),
        view_(view),
        box_(box),
        nodes_(nodes),
        options_(options),
        list_(*ImGui::GetWindowDrawList()),
        margin_(kMargin * ui.scale) {}

  void Draw() {
    const float shrink = std::clamp(box_.width() / (kWidth * ui_.scale * kPart), kLeast, 1.0F);
    const bool high = view_.bounds().height() > view_.bounds().width();
    const Point size =
        (high ? Point{kHeight, kWidth} : Point{kWidth, kHeight}) * (ui_.scale * shrink);
    MinimapState& state = view_.minimap;
    const bool has_room =
        box_.width() > 2 * size.x + margin_ && box_.height() > 2 * size.y + margin_;
    if (!has_room || IsAllInSight(view_, box_)) {
      state.holds_mouse = false;
      return;
    }
    if (state.holds_mouse) return DrawMap(InCorner(state.corner, box_, size, margin_));
    const std::vector<Box> keep_clear = KeepClear();
    const CornerChoice choice = FreestCorner(box_, size, margin_, keep_clear, state.corner);
    state.corner = choice.corner;
    state.covers = !choice.is_free;
    DrawMap(InCorner(state.corner, box_, size, margin_));
  }

 private:
  static Box Grown(const Box& box, float pixels) {
    return {box.min - Point{pixels, pixels}, box.max + Point{pixels, pixels}};
  }

  // What lies over the canvas, and the nodes that are seen with what stands out of them.
  std::vector<Box> KeepClear() const {
    std::vector<Box> boxes = {options_.occupied};
    for (const VisibleNode& node : nodes_) {
      const Box box = Grown(node.box, kClearance * ui_.scale);
      if (box.Overlaps(box_)) boxes.push_back(box);
    }
    return boxes;
  }

  void DrawMap(const Box& frame) {
    const Box& world = view_.bounds();
    Camera camera;
    camera.zoom = std::min((frame.width() - 2 * kInset) / std::max(world.width(), 1.0F),
                           (frame.height() - 2 * kInset) / std::max(world.height(), 1.0F));
    camera.offset = frame.center() - world.center() * camera.zoom;
    const bool through = view_.minimap.covers && !view_.minimap.holds_mouse;
    ui_.Fill(list_, frame, Fade(ui_.palette.panel, through ? kCovering : 1), 4 * ui_.scale);
    ui_.Frame(list_, frame, ui_.palette.border, 4 * ui_.scale);
    DrawNodes(camera);
    DrawSeen(camera, frame);
    bool hovered = false;
    ui_.Hit("canvas/minimap", frame, &hovered);
    const Point mouse = FromIm(ImGui::GetIO().MousePos);
    bool& holds_mouse = view_.minimap.holds_mouse;
    holds_mouse = hovered || ImGui::IsItemActive() || (holds_mouse && frame.Contains(mouse));
    if (ImGui::IsItemActive()) {
      const Point at = camera.ToWorld(mouse);
      view_.camera.offset = Canvas() * 0.5F - at * view_.camera.zoom;
    }
  }

  void DrawNodes(const Camera& camera) {
    const float small = camera.zoom < kFarZoom ? kFarBranch : kSmallest;
    for (std::uint32_t k = 0; k < view_.shown().size();) {
      const Box branch = camera.ToScreen(view_.BranchBounds(k));
      const bool tiny = branch.width() < small && branch.height() < small;
      Box block = tiny ? branch : camera.ToScreen(view_.BoxAt(k, ui_.now));
      block.max = {std::max(block.max.x, block.min.x + 1), std::max(block.max.y, block.min.y + 1)};
      ui_.Fill(list_, block, ColorOf(ui_, options_, *view_.scene(), view_.shown()[k]));
      k = tiny ? view_.shown_ends()[k] : k + 1;
    }
  }

  // The part of the tree that is in sight.
  void DrawSeen(const Camera& camera, const Box& frame) {
    Box seen = {camera.ToScreen(view_.camera.ToWorld({0, 0})),
                camera.ToScreen(view_.camera.ToWorld(Canvas()))};
    seen.min = {std::max(seen.min.x, frame.min.x + 2), std::max(seen.min.y, frame.min.y + 2)};
    seen.max = {std::min(seen.max.x, frame.max.x - 2), std::min(seen.max.y, frame.max.y - 2)};
    if (seen.width() > 0 && seen.height() > 0) ui_.Frame(list_, seen, ui_.palette.text, 2);
  }

  Point Canvas() const { return {box_.width(), box_.height()}; }

  const Ui& ui_;
  TreeView& view_;
  const Box box_;
  const std::vector<VisibleNode>& nodes_;
  const CanvasOptions& options_;
  ImDrawList& list_;
  const float margin_;
};

}  // namespace

Box InCorner(Corner corner, const Box& canvas, Point size, float margin) {
  const bool is_right = corner == Corner::kUpperRight || corner == Corner::kLowerRight;
  const bool is_upper = corner == Corner::kUpperRight || corner == Corner::kUpperLeft;
  const Point min = {is_right ? canvas.max.x - margin - size.x : canvas.min.x + margin,
                     is_upper ? canvas.min.y + margin : canvas.max.y - margin - size.y};
  return {min, min + size};
}

CornerChoice FreestCorner(const Box& canvas, Point size, float margin,
                          const std::vector<Box>& nodes, Corner present) {
  const auto hidden_in = [&](Corner corner) {
    const Box box = InCorner(corner, canvas, size, margin);
    float hidden = 0;
    for (const Box& node : nodes) hidden += CommonArea(box, node);
    return hidden;
  };
  Corner best = present;
  float least = hidden_in(present);
  for (const Corner corner :
       {Corner::kUpperRight, Corner::kLowerRight, Corner::kLowerLeft, Corner::kUpperLeft}) {
    const float hidden = least > 0 ? hidden_in(corner) : least;
    if (hidden >= least) continue;
    best = corner;
    least = hidden;
  }
  return {best, least <= 0};
}

void DrawMinimap(const Ui& ui, TreeView& view, const Box& box,
                 const std::vector<VisibleNode>& nodes, const CanvasOptions& options) {
  Minimap(ui, view, box, nodes, options).Draw();
}

}  // namespace coppice::editor
