// Makes a test of what a robot or a record did: a scenario beside the file of its tree.
#ifndef COPPICE_EDITOR_WORKSPACE_RUN_TEST_MAKER_H_
#define COPPICE_EDITOR_WORKSPACE_RUN_TEST_MAKER_H_

#include <string>

#include "bt_core/base/outcome.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Of the shown run, or of the stretch that is marked in its timeline. The file of its tree is the
/// one of that path, or an open file that has a tree of that ID.
Outcome SaveRunAsTest(EditorState& state, const std::string& name, double now);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_RUN_TEST_MAKER_H_
