// A script as a tree of expressions: what the parser makes, the checker completes and the generator
// turns into code. All nodes lie in one array; a node comes behind its children.
#ifndef COPPICE_BT_CORE_SCRIPT_AST_H_
#define COPPICE_BT_CORE_SCRIPT_AST_H_

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/data/inbox.h"
#include "bt_core/script/operand.h"
#include "bt_core/script/relation.h"

namespace coppice::script {

using NodeId = std::uint32_t;

/// What an expression does with its operands, in the order of their precedence.
enum class Operator : std::uint8_t {
  kLiteral,
  kName,
  kCreate,  // :=
  kAssign,  // =
  kAddTo,
  kSubtractFrom,
  kMultiplyBy,
  kDivideBy,
  kChoose,  // ?:
  kOr,
  kAnd,
  kCompare,  // a chain: a < b < c
  kBitOr,
  kBitXor,
  kBitAnd,
  kAdd,
  kSubtract,
  kJoin,  // ..
  kMultiply,
  kDivide,
  kRemainder,
  kNegate,
  kComplement,
  kNot,
  kMin,
  kMax,
  kAbsolute,
  kClamp,
};

constexpr bool IsAssignment(Operator op) {
  return op >= Operator::kCreate && op <= Operator::kDivideBy;
}

/// What is known of the result before the script runs.
enum class Family : std::uint8_t { kUnknown, kNumber, kText, kOther };

struct Node {
  Operator op = Operator::kLiteral;
  Family family = Family::kUnknown;
  std::uint16_t depth = 1;               ///< of the expression tree below
  std::uint32_t offset = 0;              ///< of the operator, name or literal in the script
  std::vector<NodeId> operands;          ///< the assigned name comes first
  std::vector<Relation> relations;       ///< of a chain, one fewer than operands
  Operand value = Operand::Bool(false);  ///< of a literal
  std::string_view name;                 ///< of a name, as written
  bool is_target = false;                ///< of a name: it is assigned to
  SlotIndex slot = kNoSlot;              ///< of a name
  const Type* type = nullptr;            ///< of the name's slot, if ports give it one
};

struct Ast {
  std::vector<Node> nodes;
  std::vector<NodeId> statements;
  std::deque<std::string> texts;  ///< what the literals of texts point into
};

}  // namespace coppice::script

#endif  // COPPICE_BT_CORE_SCRIPT_AST_H_
