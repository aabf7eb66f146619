// From the text of a script to a tree of expressions. Names are not looked at yet.
//
// A wrong statement gives one problem, and reading goes on behind its semicolon. Nesting is bounded
// by kMaxDepth, so no text can exhaust the stack.
#ifndef COPPICE_BT_CORE_SCRIPT_PARSER_H_
#define COPPICE_BT_CORE_SCRIPT_PARSER_H_

#include <string_view>
#include <vector>

#include "bt_core/script/ast.h"
#include "bt_core/script/script.h"

namespace coppice::script {

/// Of parentheses, calls, prefixes and assignments in each other.
inline constexpr int kMaxDepth = 100;

/// Of operators in one expression: a + b + c has two.
inline constexpr int kMaxOperators = 500;

/// The names in the result point into the script. With problems the result is not complete.
Ast Parse(std::string_view script, std::vector<ScriptProblem>& problems);

}  // namespace coppice::script

#endif  // COPPICE_BT_CORE_SCRIPT_PARSER_H_
