// Keeps what runs in view.
#ifndef COPPICE_EDITOR_WORKSPACE_FOLLOW_H_
#define COPPICE_EDITOR_WORKSPACE_FOLLOW_H_

#include "editor/canvas/tree_view.h"
#include "editor/live/tree_snapshot.h"

namespace coppice::editor {

struct FollowMode {
  bool is_on = false;
  Point canvas;            ///< its size in the last frame: with it the camera changes, too
  Point offset;            ///< of the camera when it was moved here last
  double rests_until = 0;  ///< the user has moved the camera himself
};

/// The deepest node that runs, the last one of several; kNoSceneNode if nothing runs.
std::uint32_t DeepestRunning(const Scene& scene, const TreeSnapshot& state);

/// Moves the camera so that the deepest running node is seen, as little as needed; rests for some
/// seconds after the user has moved it. Once per frame.
void FollowRunning(FollowMode& follow, TreeView& view, const TreeSnapshot& state, Point canvas,
                   double now);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_FOLLOW_H_
