// What the canvas tile keeps from frame to frame beside the view of the tree.
#ifndef COPPICE_EDITOR_WORKSPACE_CANVAS_STATE_H_
#define COPPICE_EDITOR_WORKSPACE_CANVAS_STATE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "editor/canvas/paint/node_look.h"
#include "editor/live/values/port_values.h"
#include "editor/workspace/comparison.h"

namespace coppice::editor {

/// Badges of the nodes, and what they were made of.
struct CanvasBadges {
  std::shared_ptr<const Scene> scene;
  std::vector<Diagnostic> problems;
  std::vector<Badge> by_node;
};

/// A tree of a file.
struct CanvasTab {
  std::string path;  ///< of the file
  std::string tree;  ///< ID
};
inline bool operator==(const CanvasTab& a, const CanvasTab& b) {
  return a.path == b.path && a.tree == b.tree;
}

/// The tree that the selected node is defined in, and how often it is used.
struct SharedTree {
  std::string id;
  std::uint64_t version = 0;  ///< of the project when that was counted
  std::size_t uses = 0;
};

struct CanvasState {
  SharedTree shared;
  CanvasBadges badges;
  PortValues port_values;
  std::unique_ptr<Comparison> comparison;  ///< null: the tree itself is shown
  std::vector<CanvasTab> tabs;             ///< in the order of opening
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_CANVAS_STATE_H_
