#include <algorithm>

#include "editor/canvas/canvas_looks.h"
#include "editor/canvas/status_look.h"

namespace coppice::editor {
namespace {

constexpr float kWidth = 178;
constexpr float kHeight = 104;
constexpr float kInset = 8;
constexpr float kPart = 4.5F;      // of the canvas' width at most one in so many,
constexpr float kLeast = 0.6F;     // but not smaller than this part of its full size
constexpr float kInSight = 0.85F;  // of the tree's area
constexpr float kSmallest = 2;     // pixels; a smaller branch is one block
constexpr float kFarZoom = 0.01F;  // from there on nodes are far smaller than a pixel:
constexpr float kFarBranch = 16;   // larger branches are one block

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

}  // namespace

void DrawMinimap(const Ui& ui, TreeView& view, const Box& box, const CanvasOptions& options) {
  const float shrink = std::clamp(box.width() / (kWidth * ui.scale * kPart), kLeast, 1.0F);
  const Point size = Point{kWidth, kHeight} * (ui.scale * shrink);
  const Point margin = Point{10, 10} * ui.scale;
  const Box frame = {{box.max.x - size.x - margin.x, box.min.y + margin.y},
                     {box.max.x - margin.x, box.min.y + margin.y + size.y}};
  if (frame.min.x < box.min.x + size.x || frame.max.y > box.max.y - size.y) return;
  if (IsAllInSight(view, box)) return;
  const Box& world = view.bounds();
  const float zoom = std::min((frame.width() - 2 * kInset) / std::max(world.width(), 1.0F),
                              (frame.height() - 2 * kInset) / std::max(world.height(), 1.0F));
  Camera camera;
  camera.zoom = zoom;
  camera.offset = frame.center() - world.center() * zoom;

  ImDrawList& list = *ImGui::GetWindowDrawList();
  ui.Fill(list, frame, ui.palette.panel, 4);
  ui.Frame(list, frame, ui.palette.border, 4);
  for (std::uint32_t k = 0; k < view.shown().size();) {
    const Box branch = camera.ToScreen(view.BranchBounds(k));
    const float small = zoom < kFarZoom ? kFarBranch : kSmallest;
    const bool tiny = branch.width() < small && branch.height() < small;
    Box block = tiny ? branch : camera.ToScreen(view.BoxAt(k, ui.now));
    block.max = {std::max(block.max.x, block.min.x + 1), std::max(block.max.y, block.min.y + 1)};
    ui.Fill(list, block, ColorOf(ui, options, *view.scene(), view.shown()[k]));
    k = tiny ? view.shown_ends()[k] : k + 1;
  }

  const Point canvas = {box.width(), box.height()};
  Box seen = {camera.ToScreen(view.camera.ToWorld({0, 0})),
              camera.ToScreen(view.camera.ToWorld(canvas))};
  seen.min = {std::max(seen.min.x, frame.min.x + 2), std::max(seen.min.y, frame.min.y + 2)};
  seen.max = {std::min(seen.max.x, frame.max.x - 2), std::min(seen.max.y, frame.max.y - 2)};
  if (seen.width() > 0 && seen.height() > 0) ui.Frame(list, seen, ui.palette.text, 2);

  ui.Hit("canvas/minimap", frame);
  if (ImGui::IsItemActive()) {
    const Point at = camera.ToWorld(FromIm(ImGui::GetIO().MousePos));
    view.camera.offset = canvas * 0.5F - at * view.camera.zoom;
  }
}

}  // namespace coppice::editor
