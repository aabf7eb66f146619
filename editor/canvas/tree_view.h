// One tree on the canvas: which nodes are collapsed, where the boxes are and where they come from,
// what is selected, and the camera. Knows neither colours nor fonts.
//
// World coordinates are pixels at zoom 1. Screen = origin of the canvas + offset + zoom * world.
#ifndef COPPICE_EDITOR_CANVAS_TREE_VIEW_H_
#define COPPICE_EDITOR_CANVAS_TREE_VIEW_H_

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "editor/canvas/tidy_tree.h"
#include "editor/scene/scene.h"

namespace coppice::editor {

struct Camera {
  Point offset;
  float zoom = 1;

  Point ToScreen(Point world) const { return offset + world * zoom; }
  Point ToWorld(Point screen) const { return (screen - offset) * (1 / zoom); }
  Box ToScreen(const Box& box) const { return {ToScreen(box.min), ToScreen(box.max)}; }
};

class TreeView {
 public:
  /// Shows a tree. `sizes` are those of its nodes without the row for collapsed children. Selection
  /// and collapsed nodes stay where the paths are still there. `now` in seconds.
  void SetScene(std::shared_ptr<const Scene> scene, std::vector<Point> sizes, double now);
  const std::shared_ptr<const Scene>& scene() const { return scene_; }

  void SetOrientation(Orientation orientation, double now);
  Orientation orientation() const { return orientation_; }

  bool IsCollapsed(std::uint32_t node) const { return collapsed_[node]; }
  /// Nodes without children are never collapsed. The node stays where it is on the screen.
  void SetCollapsed(std::uint32_t node, bool collapsed, double now);
  /// All SubTrees at once.
  void CollapseSubTrees(bool collapsed, double now);

  std::uint32_t selected() const { return selected_; }  ///< kNoNode: none
  void Select(std::uint32_t node);                      ///< opens what it is hidden in

  /// Visible nodes in preorder. The range of descendants of shown()[k] ends at shown_ends()[k].
  const std::vector<std::uint32_t>& shown() const { return shown_; }
  const std::vector<std::uint32_t>& shown_ends() const { return shown_ends_; }

  /// Box of shown()[k] in the world at that time.
  Box BoxAt(std::uint32_t k, double now) const;
  /// Around shown()[k] and all its descendants, at rest.
  const Box& BranchBounds(std::uint32_t k) const { return branches_[k]; }
  const Box& bounds() const { return layout_.bounds; }
  /// Number among shown() of a node, or of the collapsed node that hides it.
  std::uint32_t ShownOf(std::uint32_t node) const;
  bool IsMoving(double now) const;

  /// The whole tree, or the selection (with its descendants), in a canvas of that size.
  void FitAll(Point canvas);
  void FitSelection(Point canvas);
  /// Keeps the world point under `screen` there. `factor` > 1: closer.
  void ZoomAt(Point screen, float factor);
  /// Moves the camera as little as needed for the selection to be seen.
  void Reveal(Point canvas);

  Camera camera;
  bool needs_fit = true;  ///< the camera was never set; cleared by FitAll

 private:
  void Relayout(std::uint32_t anchor, double now);
  void Fit(const Box& box, Point canvas, float largest_zoom);

  std::shared_ptr<const Scene> scene_;
  std::vector<Point> sizes_;
  std::vector<bool> collapsed_;
  Orientation orientation_ = Orientation::kTopToBottom;
  std::uint32_t selected_ = kNoNode;
  std::vector<std::uint32_t> shown_, shown_ends_;
  TidyTree layout_;
  std::vector<Point> from_;  // upper left corners when the boxes began to move
  std::vector<Box> branches_;
  double moved_at_ = -1e9;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_TREE_VIEW_H_
