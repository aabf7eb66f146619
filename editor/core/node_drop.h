// Drag and drop on the canvas: turns what the canvas says about the mouse into edits.
//
//   const NodeDrop drop(state, ui.now);
//   CanvasOptions options;
//   options.drop = &drop.handler();
#ifndef COPPICE_EDITOR_CORE_NODE_DROP_H_
#define COPPICE_EDITOR_CORE_NODE_DROP_H_

#include <string>

#include "editor/canvas/drop_target.h"
#include "editor/core/editor_state.h"

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

#endif  // COPPICE_EDITOR_CORE_NODE_DROP_H_
