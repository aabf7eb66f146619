// What can run, but is hardly meant.
#ifndef COPPICE_BT_CORE_SCRIPT_DOUBTS_H_
#define COPPICE_BT_CORE_SCRIPT_DOUBTS_H_

#include <vector>

#include "bt_core/script/ast.h"
#include "bt_core/script/script.h"

namespace coppice::script {

/// Of a condition, whose last statement is what is asked for: an assignment there that is taken for
/// true or false, like `x = 3` and `(x = 3) && y`, is a warning. `(n += 1) > 3` uses the value and
/// is meant so. `ast` must have been parsed without problems.
void AddDoubts(const Ast& ast, std::vector<ScriptProblem>& problems);

}  // namespace coppice::script

#endif  // COPPICE_BT_CORE_SCRIPT_DOUBTS_H_
