// Compiles a tree of the files that are being edited, as they are in memory, for a simulation.
#ifndef COPPICE_EDITOR_SIMULATION_OPEN_TREE_H_
#define COPPICE_EDITOR_SIMULATION_OPEN_TREE_H_

#include <memory>
#include <string>

#include "bt_core/engine/program.h"
#include "bt_core/model/project.h"
#include "editor/files/linked_project.h"

namespace coppice::editor {

/// The tree of that ID (empty: the main tree) of a file and of what is linked with it
/// (linked_project.h); `models` (may be null) describe node types that the project does not. Null
/// if there are errors.
std::shared_ptr<const Program> CompileOpenTree(OpenProject& files, const std::string& path,
                                               const std::string& tree_id, const Project* models,
                                               Diagnostics& diagnostics);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SIMULATION_OPEN_TREE_H_
