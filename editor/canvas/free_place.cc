#include "editor/canvas/free_place.h"

#include <algorithm>

#include "editor/canvas/visible_nodes.h"

namespace coppice::editor {
namespace {

// In pixels of area. What the buttons are about must stay in sight more than the rest.
constexpr float kWeightOfNode = 4;

Box Within(const Box& canvas, Point at, Point size, float gap) {
  const auto inside = [gap](float wished, float low, float high, float wide) {
    return std::clamp(wished, low + gap, std::max(high - wide - gap, low + gap));
  };
  const Point corner = {inside(at.x, canvas.min.x, canvas.max.x, size.x),
                        inside(at.y, canvas.min.y, canvas.max.y, size.y)};
  return {corner, corner + size};
}

}  // namespace

Box FreePlaceBeside(const Box& node, Point size, float gap, const Box& canvas,
                    const std::vector<Box>& others) {
  const Point middle = node.center() - size * 0.5F;
  const Point wished[] = {{middle.x, node.max.y + gap},
                          {middle.x, node.min.y - gap - size.y},
                          {node.max.x + gap, middle.y},
                          {node.min.x - gap - size.x, middle.y}};
  Box best;
  float least = -1;
  for (const Point at : wished) {
    const Box box = Within(canvas, at, size, gap);
    float hidden = kWeightOfNode * CommonArea(box, node);
    for (const Box& other : others) hidden += CommonArea(box, other);
    if (least >= 0 && hidden >= least) continue;
    least = hidden;
    best = box;
  }
  return best;
}

Box FreePlaceBeside(const TreeView& view, std::uint32_t k, Point size, float gap, const Box& canvas,
                    double now) {
  Camera camera = view.camera;
  camera.offset = camera.offset + canvas.min;
  std::vector<Box> others;
  for (const VisibleNode& item : FindVisible(view, camera, canvas, now)) {
    if (item.k != k) others.push_back(item.box);
  }
  return FreePlaceBeside(camera.ToScreen(view.BoxAt(k, now)), size, gap, canvas, others);
}

}  // namespace coppice::editor
