// From a checked tree of expressions to code.
#ifndef COPPICE_BT_CORE_SCRIPT_GENERATOR_H_
#define COPPICE_BT_CORE_SCRIPT_GENERATOR_H_

#include <string_view>
#include <vector>

#include "bt_core/script/ast.h"
#include "bt_core/script/code.h"
#include "bt_core/script/script.h"

namespace coppice::script {

/// `script` is the text that the tree was made of. A script that needs more registers than there
/// are is a problem.
Code Generate(Ast ast, std::string_view script, std::vector<ScriptProblem>& problems);

}  // namespace coppice::script

#endif  // COPPICE_BT_CORE_SCRIPT_GENERATOR_H_
