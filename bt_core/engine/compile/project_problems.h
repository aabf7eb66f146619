// What can be wrong with a project before any of its trees is compiled.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_PROJECT_PROBLEMS_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_PROJECT_PROBLEMS_H_

#include <string>

#include "bt_core/engine/compile/compiler_problems.h"
#include "bt_core/engine/registry.h"
#include "bt_core/model/project.h"

namespace coppice {

/// The tree to run, or null and the reason: there is none of that ID, or the ID is empty.
const TreeDefinition* FindMainTree(const Project& project, const std::string& id,
                                   Problems& problems);

/// A tree and a node type of the same name could not be told apart in the compact form.
void CheckTreeNames(const Project& project, const Registry& registry, Problems& problems);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_PROJECT_PROBLEMS_H_
