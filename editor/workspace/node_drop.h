// Drag and drop on the canvas: turns what the canvas says about the mouse into edits.
//
//   const NodeDrop drop(state, ui.now);
//   CanvasOptions options;
//   options.drop = &drop.handler();
#ifndef COPPICE_EDITOR_WORKSPACE_NODE_DROP_H_
#define COPPICE_EDITOR_WORKSPACE_NODE_DROP_H_

#include <string>

#include "editor/canvas/drop_target.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

class NodeDrop {
 public:
  /// `state` must outlive it.
  NodeDrop(EditorState& state, double now);

  /// For the canvas of the shown tree.
  const DropHandler& handler() const { return handler_; }

 private:
  DropHandler handler_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_NODE_DROP_H_
