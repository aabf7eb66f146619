// One frame of a timeline: what is drawn, and where.
#ifndef COPPICE_EDITOR_PANELS_TIMELINE_FRAME_H_
#define COPPICE_EDITOR_PANELS_TIMELINE_FRAME_H_

#include <vector>

#include "editor/core/editor_state.h"
#include "editor/look/ui.h"
#include "editor/timeline/columns.h"

namespace coppice::editor {

inline constexpr float kLaneHeight = 17;  ///< pixels at scale 1

struct TimelineFrame {
  const Ui& ui;
  EditorState& state;
  RunView& view;
  const coppice::editor::Run& run;
  Playhead& head;
  TimelineState& shown;
  const Tracks& tracks;
  Box labels, overview, ruler, lanes;
  Time run_end{0};              ///< until when the last tick holds
  std::vector<Column> columns;  ///< of the lanes

  float XOf(Time time) const {
    return lanes.min.x + static_cast<float>(shown.view.PartOf(time)) * lanes.width();
  }
  Time TimeAtX(float x) const {
    return shown.view.At(static_cast<double>((x - lanes.min.x) / lanes.width()));
  }
};

/// The mouse scrubs, pans, zooms and marks. "timeline/lanes", "timeline/overview".
void HandleTimelineMouse(TimelineFrame& frame);

/// Chooses the lanes and draws them. "timeline/PATH".
void DrawTimelineLanes(TimelineFrame& frame);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_TIMELINE_FRAME_H_
