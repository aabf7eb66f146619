// One tree on the canvas: which nodes are collapsed, where the boxes are and where they come from,
// what is selected, and the camera. Knows neither colours nor fonts.
//
// When nodes get new places, by an edit, another style or folding, one of them holds still on the
// screen: that below the mouse, or within reach of it; else the one that the change is about, if it
// is seen; else that in the middle. If that one has gone, the nearest above it.
//
// World coordinates are pixels at zoom 1. Screen = origin of the canvas + offset + zoom * world.
#ifndef COPPICE_EDITOR_CANVAS_TREE_VIEW_H_
#define COPPICE_EDITOR_CANVAS_TREE_VIEW_H_

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/canvas/layout/layout_choice.h"
#include "editor/canvas/minimap.h"
#include "editor/canvas/paint/edge_shape.h"
#include "editor/diff/tree_match.h"
#include "editor/scene/key_uses.h"
#include "editor/scene/scene.h"

namespace coppice::editor {

struct Camera {
  Point offset;
  float zoom = 1;

  Point ToScreen(Point world) const { return offset + world * zoom; }
  Point ToWorld(Point screen) const { return (screen - offset) * (1 / zoom); }
  Box ToScreen(const Box& box) const { return {ToScreen(box.min), ToScreen(box.max)}; }
  EdgeEnds ToScreen(EdgeEnds world) const;
};
inline bool operator==(const Camera& a, const Camera& b) {
  return a.offset == b.offset && a.zoom == b.zoom;
}

/// What is being dragged.
struct Drag {
  std::vector<std::uint32_t> nodes;  ///< of this scene, rising; empty: something new
  std::string label;                 ///< painted beside the mouse
};

/// What the mouse is doing on the canvas, from one frame to the next.
struct Gesture {
  enum class Kind : std::uint8_t {
    kNone,
    kPressed,    ///< a button is down; it may become one of the others
    kPan,        ///< the canvas follows the mouse
    kRectangle,  ///< what is inside becomes selected
    kDrag,       ///< nodes are being carried
    kCancelled   ///< until the button is let go
  };
  Kind kind = Kind::kNone;
  Point start;                        ///< in the world
  std::uint32_t node = kNoSceneNode;  ///< that was below the mouse when the button went down
  Drag drag;                          ///< of kDrag
};

class TreeView {
 public:
  /// The sizes of a node of that scene at zoom 1.
  using SizeOf = std::function<NodeSizes(const Scene&, const SceneNode&)>;

  /// Shows a tree. `size_of` measures its nodes without the row for collapsed children. If it is
  /// another version of the one that is shown, selection and collapsed nodes stay with their nodes,
  /// which move to their new places, and only nodes that look different are measured. `now` in
  /// seconds.
  void SetScene(std::shared_ptr<const Scene> scene, const SizeOf& size_of, double now);
  const std::shared_ptr<const Scene>& scene() const { return scene_; }

  /// The nodes of the scene have other sizes now.
  void MeasureAgain(const SizeOf& size_of, double now);

  /// For a style that asks for it another layout is chosen. A tree that was fitted is fitted again
  /// in the next frame, unless the mouse is on one of its nodes.
  void SetStyle(const LayoutStyle& style, double now);
  const LayoutStyle& style() const { return style_; }
  /// Which way it grows now.
  Orientation orientation() const { return choice_.orientation; }
  /// Whether it stands in rows, not as a tidy tree.
  bool in_rows() const { return choice_.rows > 0; }
  /// Whether nodes show nothing but their names now.
  bool names_only() const { return choice_.names_only; }

  /// Without it, nodes jump to their places.
  bool animated = true;
  /// Of the screen; a tree is not fitted larger than that, but on a wide canvas. With another one
  /// the tree is as much larger, around the middle of the canvas.
  void SetScreenScale(float scale);
  float screen_scale() const { return screen_scale_; }

  bool IsCollapsed(std::uint32_t node) const { return collapsed_[node]; }
  /// Nodes without children are never collapsed.
  void SetCollapsed(std::uint32_t node, bool collapsed, double now);
  /// All SubTrees at once.
  void CollapseSubTrees(bool collapsed, double now);
  /// Everything that neither holds a selected node nor is selected. Without a selection nothing.
  void CollapseOthers(double now);
  void OpenAll(double now);
  /// Path and ID of those that are collapsed, "1.2 Sequence": what a later version of the tree can
  /// be asked for.
  std::vector<std::string> ClosedNodes() const;
  /// Before the view is painted for the first time: collapses these, as far as they are there.
  void CloseAtFirst(const std::vector<std::string>& nodes);

  /// The node that was selected last; kNoSceneNode: none.
  std::uint32_t selected() const { return selected_; }
  /// Its number in the run; kNoNode if it has none or nothing is selected.
  NodeIndex selected_run_node() const {
    return selected_ == kNoSceneNode ? kNoNode : scene_->nodes[selected_].run_node;
  }
  /// All that are selected, rising.
  const std::vector<std::uint32_t>& selection() const { return selection_; }
  bool IsSelected(std::uint32_t node) const;
  /// That node alone, or nothing. Opens what it is hidden in.
  void Select(std::uint32_t node);
  /// Adds it to the selection, or takes it out.
  void ToggleSelected(std::uint32_t node);
  /// Adds everything from the node that was selected last to this one: siblings if they are, else
  /// all visible nodes between them.
  void SelectTo(std::uint32_t node);
  /// Exactly these; the last one becomes selected().
  void SelectAll(std::vector<std::uint32_t> nodes);

  /// Lights a key of keys(), so that all others step back; kNoKey: none.
  void LightKey(std::uint32_t key) { lit_key_ = key; }
  std::uint32_t lit_key() const { return lit_key_; }
  const KeyUses& keys() const { return keys_; }

  /// Visible nodes in preorder. The range of descendants of shown()[k] ends at shown_ends()[k].
  const std::vector<std::uint32_t>& shown() const { return shown_; }
  const std::vector<std::uint32_t>& shown_ends() const { return shown_ends_; }
  /// Number among shown() of the parent of shown()[k]; 0 for the root.
  std::uint32_t ShownParent(std::uint32_t k) const { return shown_parents_[k]; }

  /// Box of shown()[k] in the world at that time.
  Box BoxAt(std::uint32_t k, double now) const;
  /// Around shown()[k] and all its descendants, at rest.
  const Box& BranchBounds(std::uint32_t k) const { return branches_[k]; }
  const Box& bounds() const { return layout_.bounds; }
  Link LinkOf(std::uint32_t k) const { return layout_.links[k]; }
  /// The line from the parent of shown()[k], k > 0, to it at that time, in the world; without
  /// notes.
  EdgeEnds EdgeTo(std::uint32_t k, double now) const;
  /// Number among shown() of a node, or of the collapsed node that hides it.
  std::uint32_t ShownOf(std::uint32_t node) const;
  bool IsMoving(double now) const;

  /// Where on the screen the view is painted; before each frame. A view that was never fitted shows
  /// all of its tree if that can be read, else its top. When the place changes, one that was fitted
  /// and not moved since stays fitted; any other keeps its nodes where they are on the screen. A
  /// fitted one does so too, as far as they fit, when the mouse is on a node, or when only the
  /// upper edge moves: bars that come and go above the canvas do not make the tree jump.
  void PlaceIn(const Box& canvas);
  /// The whole tree, or the selection (with its descendants), in a canvas of that size.
  void FitAll(Point canvas);
  void FitSelection(Point canvas);
  /// Keeps the world point under `screen` there. `factor` > 1: closer.
  void ZoomAt(Point screen, float factor);
  /// Moves the camera as little as needed for the selection to be seen.
  void Reveal(Point canvas);

  /// The same, and as close that the node can be read.
  void RevealReadable(Point canvas);
  /// The same if the middle of the node that was selected last is not seen.
  void RevealIfLost(Point canvas);

  Camera camera;
  Gesture gesture;             ///< of the mouse on the canvas
  std::optional<Point> mouse;  ///< on the screen, while it is on the canvas
  MinimapState minimap;
  bool needs_fit = true;  ///< to be shown as if for the first time; cleared by FitAll

 private:
  static constexpr double kAtRest = std::numeric_limits<double>::infinity();  // when nothing moves
  static constexpr double kNeverMoved = -1e9;

  // Where the nodes of the scene are on the canvas; only those with `known` are there.
  struct Places {
    std::vector<Box> at;
    std::vector<bool> known;
  };

  Places PlacesAt(double now) const;
  Point MouseInWorld() const;
  std::uint32_t Nearest(Point world, double now) const;
  bool IsMouseOnNode() const;
  std::uint32_t Anchor(std::uint32_t wanted, double now) const;
  void Relayout(std::uint32_t anchor, double now);
  void Move(const Places& before, std::uint32_t anchor, double now);
  void ListShown();
  void LayOutShown();
  void TakeLayout(TreeLayout layout);
  void OpenAround(std::uint32_t node);
  void Fit(const Box& box, Point canvas, float largest_zoom);
  float LargestFit(Point canvas) const;
  float ZoomOfAll(Point canvas) const;
  void Choose(Point canvas);
  void ShowAtFirst(Point canvas);
  void ShowTop(Point canvas);
  MeasuredTree Measured() const;
  bool IsInSight(Point canvas) const;
  bool MoveIntoSight(Point canvas);

  float screen_scale_ = 1;
  std::shared_ptr<const Scene> scene_;
  TreeHashes hashes_;
  std::vector<NodeSizes> sizes_;
  std::vector<bool> collapsed_;
  LayoutStyle style_;
  LayoutChoice choice_;  // for the canvas where it was fitted
  float readable_ = 1;   // least zoom at which that can be read
  bool can_be_read_ = true;
  KeyUses keys_;
  std::uint32_t lit_key_ = kNoKey;
  std::uint32_t selected_ = kNoSceneNode;
  std::vector<std::uint32_t> selection_;
  std::vector<std::uint32_t> shown_, shown_ends_, shown_parents_;
  TreeLayout layout_;
  std::vector<Point> from_;  // upper left corners when the boxes began to move
  std::vector<Box> branches_;
  double moved_at_ = kNeverMoved;
  Box canvas_;             // of the last frame
  Camera fitted_;          // if that is the camera, the tree was fitted and not moved since
  bool at_first_ = false;  // ... by ShowAtFirst
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_TREE_VIEW_H_
