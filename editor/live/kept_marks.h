// What the user has marked, as a text that is kept from one start of the editor to the next: the
// breakpoints of robots and the bookmarks of records. Faults are not kept: they begin only when
// somebody wants them.
//
//   {"breakpoints": [{"robot": "r:1667", "path": "round/Drive", "condition": "battery < 20"}],
//    "bookmarks": {"/runs/night.coppice": [{"tick": 4711, "text": "here it turns"}]}}
#ifndef COPPICE_EDITOR_LIVE_KEPT_MARKS_H_
#define COPPICE_EDITOR_LIVE_KEPT_MARKS_H_

#include <string>

#include "bt_core/base/diagnostic.h"
#include "editor/live/hook_list.h"
#include "editor/timeline/bookmarks.h"

namespace coppice::editor {

std::string WriteMarks(const HookList& hooks, const Bookmarks& bookmarks);

/// Adds what the text says. A text that is none adds nothing, and the reason to `diagnostics`;
/// `file` is for that.
void ReadMarks(const std::string& text, const std::string& file, HookList& hooks,
               Bookmarks& bookmarks, Diagnostics& diagnostics);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_KEPT_MARKS_H_
