// What names mean, and whether operators and operands fit as far as that is known before a run.
#ifndef COPPICE_BT_CORE_SCRIPT_CHECKER_H_
#define COPPICE_BT_CORE_SCRIPT_CHECKER_H_

#include <vector>

#include "bt_core/script/ast.h"
#include "bt_core/script/script.h"

namespace coppice::script {

/// Gives every name its slot or turns it into a literal, if it is a constant; computes operators on
/// literal numbers; adds what cannot work to the problems.
void Check(Ast& ast, ScriptNames& names, const ScriptConstants& constants,
           std::vector<ScriptProblem>& problems);

}  // namespace coppice::script

#endif  // COPPICE_BT_CORE_SCRIPT_CHECKER_H_
