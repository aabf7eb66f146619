// What the user has set in the timeline of a run.
#ifndef COPPICE_EDITOR_WORKSPACE_TIMELINE_STATE_H_
#define COPPICE_EDITOR_WORKSPACE_TIMELINE_STATE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "bt_core/engine/events/event_words.h"
#include "editor/timeline/time_view.h"

namespace coppice::editor {

/// What the mouse moves while it is held.
enum class TimelineDrag : std::uint8_t { kPan, kScrub, kOverview, kRange };

struct TimelineState {
  TimeView view;
  float scroll = 0;               ///< of the lanes [pixels]
  std::vector<NodeIndex> listed;  ///< whose lanes are shown, from the top
  std::size_t pinned = 0;         ///< so many of them stay on top
  Time shown = Time::min();       ///< where the playhead was in the last frame
  bool was_held = false;          ///< and that it was not at now
  TimelineDrag drag = TimelineDrag::kScrub;
  Time drag_from{};
  /// A stretch that was marked; statistics are of it alone.
  std::optional<std::pair<Time, Time>> range;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_TIMELINE_STATE_H_
