#include "bt_core/script/doubts.h"

#include <string>

namespace coppice::script {
namespace {

// Its operands are taken for true or false, as its result is.
bool HandsTruthOn(Operator op) {
  return op == Operator::kOr || op == Operator::kAnd || op == Operator::kNot ||
         op == Operator::kChoose;
}

ScriptProblem Doubt(const Ast& ast, const Node& assignment) {
  const std::string key(ast.nodes[assignment.operands.front()].name);
  return {assignment.offset, "this condition assigns to \"" + key + "\"",
          assignment.op == Operator::kAssign ? "did you mean \"==\"?" : "", true};
}

}  // namespace

void AddDoubts(const Ast& ast, std::vector<ScriptProblem>& problems) {
  std::vector<NodeId> open = {ast.statements.back()};
  while (!open.empty()) {
    const Node& node = ast.nodes[open.back()];
    open.pop_back();
    if (IsAssignment(node.op)) problems.push_back(Doubt(ast, node));
    if (HandsTruthOn(node.op)) {
      open.insert(open.end(), node.operands.rbegin(), node.operands.rend());
    }
  }
}

}  // namespace coppice::script
