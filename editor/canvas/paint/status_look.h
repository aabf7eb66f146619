// The status of a node as colours, glyphs and strengths. Statuses fade: the result of a node that
// is idle again is shown at full strength at first and as a weak trail after two seconds. A node
// that went idle while it ran was halted, which is no result.
#ifndef COPPICE_EDITOR_CANVAS_PAINT_STATUS_LOOK_H_
#define COPPICE_EDITOR_CANVAS_PAINT_STATUS_LOOK_H_

#include "editor/live/tree_snapshot.h"
#include "editor/theme/ui.h"

namespace coppice::editor {

/// Idle after something.
bool IsTrail(const NodeState& state);
bool WasHalted(const NodeState& state);

/// Colour of the status, of the trail if the node is idle, else of nodes at rest.
Color StatusColor(const Palette& palette, const NodeState& state, Color at_rest);

/// The glyph of the status or of the trail; empty for a node that never ran.
const char* StatusGlyph(const NodeState& state);

/// 1 for a status; for a trail from 1 down to 0.45 two seconds later.
float StatusStrength(const NodeState& state, Time now);

/// How much a status that has just come flashes: (1 - t / 0.4 s) squared, then 0.
float FlashStrength(const NodeState& state, Time now);

/// Between 0 and 1, at most every 0.8 seconds; 0.5 all the time if motion is reduced.
float Pulse(const Ui& ui);

/// True while something of it changes with time alone.
bool IsFading(const NodeState& state, Time now);

/// A colour for a share from 0 (cold) to 1 (hot); lighter means hotter on dark, darker on light.
Color HeatColor(const Palette& palette, float heat);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_PAINT_STATUS_LOOK_H_
