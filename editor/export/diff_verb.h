// `coppice diff A.xml B.xml`: what became of the trees, in words and as a picture.
//
//   MainTree: 1 added, 1 changed
//     ~ 1.2 Retry: num_attempts "3" -> "5"   b.xml:12
//     + 1.3 OpenDoor                         b.xml:14
//   - tree PickLock
#ifndef COPPICE_EDITOR_EXPORT_DIFF_VERB_H_
#define COPPICE_EDITOR_EXPORT_DIFF_VERB_H_

#include <string>
#include <vector>

#include "bt_core/base/command_line.h"

namespace coppice::editor {

const Command& DiffCommand();

/// Runs it with the arguments behind the verb. Returns 0 if the trees are the same, 1 if they
/// differ, 2 if they cannot be compared, as diff(1) does.
int RunDiff(const std::vector<std::string>& arguments);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_EXPORT_DIFF_VERB_H_
