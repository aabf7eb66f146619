// Paints what a timeline consists of: bars of statuses, columns of activity, hatched gaps.
#ifndef COPPICE_EDITOR_PANELS_TIMELINE_LANE_PAINTER_H_
#define COPPICE_EDITOR_PANELS_TIMELINE_LANE_PAINTER_H_

#include <string>
#include <vector>

#include "editor/theme/ui.h"
#include "editor/timeline/columns.h"

namespace coppice::editor {

/// The status that a column shows if there is room for one only: FAILURE before RUNNING before the
/// others.
Status WorstOf(StatusSet statuses);

/// The bars of one node in `box`; one column is as wide as box.width() / `columns`. Where several
/// statuses fall into one column, it is divided among them, so nothing vanishes. A bar is wide
/// enough for the name of its status, or has a form that says it without the colour. The bar at
/// `now_x`, where the playhead stands, has its full colour; what was and what comes is dimmed.
void PaintBars(const Ui& ui, ImDrawList& list, const Box& box, const std::vector<Bar>& bars,
               std::size_t columns, float now_x);

/// Something is missing here.
void PaintHatched(const Ui& ui, ImDrawList& list, const Box& box, Color color);

/// Distance between two marks of a time axis, so that there are at most `most` of them.
Duration MarkDistance(Duration span, int most);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_TIMELINE_LANE_PAINTER_H_
