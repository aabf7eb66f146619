// The operators and functions of scripts, as tables.
#ifndef COPPICE_BT_CORE_SCRIPT_GRAMMAR_H_
#define COPPICE_BT_CORE_SCRIPT_GRAMMAR_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/script/ast.h"
#include "bt_core/script/token.h"

namespace coppice::script {

/// An operator between two operands. A higher precedence binds closer.
struct BinaryOperator {
  std::string_view symbol;
  int precedence;
  Operator op;
  Relation relation = Relation::kEqual;  ///< of kCompare
};
inline constexpr int kLowestPrecedence = 1;

struct Function {
  std::string_view name;
  Operator op;
  std::size_t fewest;
  std::size_t most;  ///< arguments
};

// All of these return null if the token is none.
const BinaryOperator* FindBinary(const Token& token);
const Operator* FindAssignment(const Token& token);
const Operator* FindPrefix(const Token& token);
const Function* FindFunction(std::string_view name);

std::vector<std::string> FunctionNames();

/// As in a script: "+=", "&&", "min".
std::string_view SymbolOf(Operator op);

/// What to write for an operator of other languages, "and" or "<>", that begins at `token`; empty
/// if there is none.
std::string HintForForeignOperator(const Token& before, const Token& token);

}  // namespace coppice::script

#endif  // COPPICE_BT_CORE_SCRIPT_GRAMMAR_H_
