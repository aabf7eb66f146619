#include "editor/workspace/follow.h"

#include <algorithm>

namespace coppice::editor {
namespace {

constexpr double kRest = 5;        // seconds
constexpr float kMargin = 40;      // pixels around the node
constexpr double kFollowed = 0.5;  // part of the way in a frame, so that it glides

// How far a stretch must move to lie within [margin, size - margin].
float Shift(float low, float high, float size) {
  const float margin = std::min(kMargin, size / 4);
  if (low < margin) return margin - low;
  if (high > size - margin) return std::max(size - margin - high, margin - low);
  return 0;
}

}  // namespace

std::uint32_t DeepestRunning(const Scene& scene, const TreeSnapshot& state) {
  std::uint32_t found = kNoSceneNode;
  std::size_t deepest = 0;
  for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
    const SceneNode& node = scene.nodes[i];
    if (node.run_node >= state.states.size()) continue;
    if (state.states[node.run_node].status != Status::kRunning) continue;
    if (found == kNoSceneNode || node.path.size() >= deepest) {
      found = i;
      deepest = node.path.size();
    }
  }
  return found;
}

void FollowRunning(FollowMode& follow, TreeView& view, const TreeSnapshot& state, Point canvas,
                   double now) {
  const bool is_resized = !(follow.canvas == canvas);
  const Point moved = is_resized ? Point{} : view.camera.offset - follow.offset;
  follow.canvas = canvas;
  if (std::abs(moved.x) + std::abs(moved.y) > 0.5F) follow.rests_until = now + kRest;
  follow.offset = view.camera.offset;
  if (!follow.is_on || now < follow.rests_until || canvas.x <= 0) return;
  const std::uint32_t node = DeepestRunning(*view.scene(), state);
  if (node == kNoSceneNode) return;
  const Box box = view.camera.ToScreen(view.BoxAt(view.ShownOf(node), now));
  const Point shift = {Shift(box.min.x, box.max.x, canvas.x),
                       Shift(box.min.y, box.max.y, canvas.y)};
  const bool is_near = std::abs(shift.x) + std::abs(shift.y) < 2;
  view.camera.offset =
      view.camera.offset + shift * (is_near ? 1.0F : static_cast<float>(kFollowed));
  follow.offset = view.camera.offset;
}

}  // namespace coppice::editor
