// What the user must know of the tree on the canvas, in bars above it: there is unsaved work of the
// last time; somebody else has changed its file too; its text is malformed, or that of the
// simulated tree is; the selected node belongs to a SubTree that is used in other places as well.
// Registers "banner/unsaved", "banner/restore", "banner/forget", "banner/dispute",
// "banner/resolve", "banner/stale", "banner/simulation", "banner/shared" and "banner/uses".
#ifndef COPPICE_EDITOR_PANELS_CANVAS_BANNERS_H_
#define COPPICE_EDITOR_PANELS_CANVAS_BANNERS_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Draws them at the top of `box` and returns what is left of it.
Box DrawCanvasBanners(const Ui& ui, EditorState& state, const Box& box);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_CANVAS_BANNERS_H_
