// What the user has marked, as a text that is kept from one start of the editor to the next: the
// breakpoints and log-points, the bookmarks of records, the lanes that were pinned. Faults are not
// kept: they begin only when somebody wants them.
//
//   {"breakpoints": [{"robot": "r:1667", "path": "round/Drive", "condition": "battery < 20"}],
//    "log_points": [{"run": "r:1667", "path": "round/Drive", "text": "to {goal}"}],
//    "bookmarks": {"/runs/night.coppice": [{"tick": 4711, "text": "here it turns"}]},
//    "pins": {"r:1667": ["round/Drive"]}}
#ifndef COPPICE_EDITOR_LIVE_KEPT_MARKS_H_
#define COPPICE_EDITOR_LIVE_KEPT_MARKS_H_

#include <string>

#include "bt_core/base/diagnostic.h"
#include "editor/live/hook_list.h"
#include "editor/live/log_points.h"
#include "editor/timeline/bookmarks.h"
#include "editor/timeline/lane_pins.h"

namespace coppice::editor {

/// All that is kept; the lists must live longer.
struct Marks {
  HookList& hooks;
  LogPoints& log_points;
  Bookmarks& bookmarks;
  LanePins& pins;
};

/// Whether there is anything to keep.
bool HasAny(const Marks& marks);

std::string WriteMarks(const Marks& marks);

/// Adds what the text says. A text that is none adds nothing, and the reason to `diagnostics`;
/// `file` is for that.
void ReadMarks(const std::string& text, const std::string& file, const Marks& marks,
               Diagnostics& diagnostics);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_KEPT_MARKS_H_
