// One frame of a timeline: what is drawn, and where.
#ifndef COPPICE_EDITOR_PANELS_TIMELINE_TIMELINE_FRAME_H_
#define COPPICE_EDITOR_PANELS_TIMELINE_TIMELINE_FRAME_H_

#include <algorithm>
#include <cstddef>
#include <vector>

#include "editor/theme/ui.h"
#include "editor/timeline/columns.h"
#include "editor/workspace/editor_state.h"

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
  Time run_end{};               ///< until when the last tick holds
  std::vector<Column> columns;  ///< of the lanes

  float XOf(Time time) const {
    return lanes.min.x + static_cast<float>(shown.view.PartOf(time)) * lanes.width();
  }
  /// Of the playhead.
  float NowX() const { return XOf(head.is_at_now() ? run_end : head.time()); }
  /// Where a row of `shown.listed` begins; those that are not pinned scroll.
  float TopOf(std::size_t row) const {
    const float top = lanes.min.y + kLaneHeight * ui.scale * static_cast<float>(row);
    return row < shown.pinned ? top : top - shown.scroll;
  }
  std::size_t RowAt(float y) const {
    const float height = kLaneHeight * ui.scale;
    const auto row = [&](float at) {
      return static_cast<std::size_t>(std::max(at, 0.0F) / height);
    };
    const std::size_t pinned = row(y - lanes.min.y);
    return pinned < shown.pinned ? pinned : row(y - lanes.min.y + shown.scroll);
  }
  Time TimeAtX(float x) const {
    return shown.view.At(static_cast<double>((x - lanes.min.x) / lanes.width()));
  }
};

/// The mouse scrubs, pans, zooms and marks. "timeline/lanes", "timeline/overview".
void HandleTimelineMouse(TimelineFrame& frame);

/// Chooses the lanes and draws them. "timeline/PATH", "timeline/pin/PATH".
void DrawTimelineLanes(TimelineFrame& frame);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_TIMELINE_TIMELINE_FRAME_H_
