// One pass over the nodes, operands first, for types go upwards. A key without a declared type may
// be anything until the tree runs, so only what cannot work with any value is a problem; the rest
// is left to the interpreter. Operators on literals are computed here with the functions of the
// run, so a folded expression cannot mean something else.
#include "bt_core/script/checker.h"

#include <numeric>
#include <string>
#include <utility>

#include "bt_core/data/enum.h"
#include "bt_core/script/grammar.h"
#include "bt_core/script/store.h"

namespace coppice::script {
namespace {

using Kind = Operand::Kind;

std::string Quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

Family FamilyOf(const Type* type) {
  if (!type) return Family::kUnknown;
  if (type->kind == TypeKind::kString) return Family::kText;
  return type->kind == TypeKind::kOther ? Family::kOther : Family::kNumber;
}

Family FamilyOf(const Operand& literal) {
  return literal.kind == Kind::kText ? Family::kText : Family::kNumber;
}

// The result of an operator of numbers. Throws Failure.
Operand Apply(Operator op, const std::vector<Operand>& operands) {
  switch (op) {
    case Operator::kBitOr:
      return BitOr(operands[0], operands[1]);
    case Operator::kBitXor:
      return BitXor(operands[0], operands[1]);
    case Operator::kBitAnd:
      return BitAnd(operands[0], operands[1]);
    case Operator::kAdd:
      return Add(operands[0], operands[1]);
    case Operator::kSubtract:
      return Subtract(operands[0], operands[1]);
    case Operator::kMultiply:
      return Multiply(operands[0], operands[1]);
    case Operator::kDivide:
      return Divide(operands[0], operands[1]);
    case Operator::kRemainder:
      return Remainder(operands[0], operands[1]);
    case Operator::kNegate:
      return Negate(operands[0]);
    case Operator::kComplement:
      return Complement(operands[0]);
    case Operator::kAbsolute:
      return Absolute(operands[0]);
    case Operator::kClamp:
      return Clamp(operands[0], operands[1], operands[2]);
    case Operator::kMin:
      return std::accumulate(operands.begin() + 1, operands.end(), operands[0], Min);
    case Operator::kMax:
      return std::accumulate(operands.begin() + 1, operands.end(), operands[0], Max);
    default:
      return Operand::Bool(!IsTrue(operands[0]));
  }
}

class Checker {
 public:
  Checker(Ast& ast, ScriptNames& names, const ScriptConstants& constants,
          std::vector<ScriptProblem>& problems)
      : ast_(ast), names_(names), constants_(constants), problems_(problems) {}

  // Children lie in front of their parents.
  void Run() {
    for (Node& node : ast_.nodes) {
      try {
        CheckNode(node);
      } catch (const Failure& failure) {
        Problem(node, failure.message);
      }
    }
  }

 private:
  void CheckNode(Node& node) {
    switch (node.op) {
      case Operator::kLiteral:
        node.family = FamilyOf(node.value);
        return;
      case Operator::kName:
        return Resolve(node);
      case Operator::kChoose:
        CheckTruth(OperandAt(node, 0));
        node.family = OperandAt(node, 1).family == OperandAt(node, 2).family
                          ? OperandAt(node, 1).family
                          : Family::kUnknown;
        return;
      case Operator::kOr:
      case Operator::kAnd:
        CheckTruth(OperandAt(node, 0));
        CheckTruth(OperandAt(node, 1));
        node.family = Family::kNumber;
        return;
      case Operator::kNot:
        CheckTruth(OperandAt(node, 0));
        return Fold(node);
      case Operator::kCompare:
        return CheckComparison(node);
      case Operator::kJoin:
        node.family = Family::kText;
        return;
      default:
        return IsAssignment(node.op) ? CheckAssignment(node) : CheckArithmetic(node);
    }
  }

  const Node& OperandAt(const Node& node, std::size_t k) const {
    return ast_.nodes[node.operands[k]];
  }

  void Resolve(Node& node) {
    const auto constant = constants_.find(node.name);
    if (constant == constants_.end()) {
      node.slot = names_.Slot(node.name);
      node.type = names_.TypeOf(node.slot);
      node.family = FamilyOf(node.type);
    } else if (names_.IsKey(node.name)) {
      Problem(node, Quoted(node.name) + " is both a constant and a key",
              "give the key another name");
    } else if (node.is_target) {
      Problem(node, Quoted(node.name) + " is a constant and cannot be assigned to",
              "give the key another name");
    } else {
      node.op = Operator::kLiteral;
      node.value = constants_.are_real ? Operand::Double(static_cast<double>(constant->second))
                                       : Operand::Integer(constant->second);
      node.family = Family::kNumber;
    }
  }

  void CheckTruth(const Node& node) {
    if (node.family == Family::kOther) {
      Problem(node, NameOf(node) + " is neither true nor false", "expected a bool or a number");
    }
    if (node.op != Operator::kLiteral) return;
    try {
      IsTrue(node.value);
    } catch (const Failure& failure) {
      Problem(node, failure.message);
    }
  }

  void CheckArithmetic(Node& node) {
    bool texts = true;
    bool fits = true;
    for (const NodeId id : node.operands) {
      const Family family = ast_.nodes[id].family;
      texts = texts && family != Family::kNumber && family != Family::kOther;
      fits = fits && family != Family::kText && family != Family::kOther;
    }
    node.family = Family::kNumber;
    if (node.op == Operator::kAdd && texts) {
      const bool certain =
          OperandAt(node, 0).family == Family::kText || OperandAt(node, 1).family == Family::kText;
      node.family = certain ? Family::kText : Family::kUnknown;
    } else if (!fits) {
      const bool add = node.op == Operator::kAdd;
      Problem(node, Quoted(SymbolOf(node.op)) + " takes numbers" + (add ? " or two texts" : ""),
              add ? "\"..\" joins a text and a number" : "");
    } else {
      Fold(node);
    }
  }

  // Computes an operator on literals.
  void Fold(Node& node) {
    node.family = Family::kNumber;
    std::vector<Operand> operands;
    for (const NodeId id : node.operands) {
      const Node& operand = ast_.nodes[id];
      if (operand.op != Operator::kLiteral || operand.family != Family::kNumber) return;
      operands.push_back(operand.value);
    }
    node.value = Apply(node.op, operands);
    node.op = Operator::kLiteral;
  }

  void CheckComparison(Node& node) {
    node.family = Family::kNumber;
    for (std::size_t i = 0; i < node.relations.size(); ++i) {
      const Node& left = OperandAt(node, i);
      const Node& right = OperandAt(node, i + 1);
      const bool other = left.family == Family::kOther || right.family == Family::kOther;
      const bool number = left.family == Family::kNumber || right.family == Family::kNumber;
      if (other && number) {
        Problem(node, NameAndType(left) + " and " + NameAndType(right) + " cannot be compared");
      }
      CheckText(right, left);
      CheckText(left, right);
    }
  }

  // A literal text that is compared with a key of another type, or assigned to it, must be a value
  // of that type.
  void CheckText(const Node& literal, const Node& key) {
    const bool is_text = literal.op == Operator::kLiteral && literal.family == Family::kText;
    if (!is_text || !key.type || key.type->kind == TypeKind::kString) return;
    Value read;
    if (read.Parse(*key.type, literal.value.text())) return;
    Problem(literal,
            Describe(literal.value) + " is no value of type " + key.type->name + ", which " +
                NameOf(key) + " has",
            key.type->enumerators ? "it is " + Choices(*key.type->enumerators) : "");
  }

  void CheckAssignment(Node& node) {
    const Node& key = OperandAt(node, 0);
    const Node& value = OperandAt(node, 1);
    if (node.op == Operator::kAssign && names_.IsDeclared(key.slot)) node.op = Operator::kCreate;
    const bool may_convert = key.family == Family::kUnknown && value.family != Family::kText;
    node.family = may_convert ? value.family : key.family;  // a text may be read as a number
    if (node.op != Operator::kCreate && node.op != Operator::kAssign) {
      return CheckCompound(node, key, value);
    }
    if (!key.type) return;
    CheckText(value, key);
    const bool refused = (value.family == Family::kNumber && key.family == Family::kOther) ||
                         (value.family == Family::kOther && value.type != key.type);
    if (refused) {
      Problem(node, "a key of type " + std::string(key.type->name) + " cannot take this value");
    } else if (value.op == Operator::kLiteral && value.family == Family::kNumber) {
      Slot slot;
      Store(value.value, key.type, slot, Time{});
    }
  }

  void CheckCompound(const Node& node, const Node& key, const Node& value) {
    const bool text = key.family == Family::kText || value.family == Family::kText;
    const bool number = key.family == Family::kNumber || value.family == Family::kNumber;
    const bool other = key.family == Family::kOther || value.family == Family::kOther;
    const bool add = node.op == Operator::kAddTo;
    if (other || (text && (number || !add))) {
      Problem(node, Quoted(SymbolOf(node.op)) + " takes numbers" + (add ? " or two texts" : ""),
              add ? "key := key .. value joins a text and a number" : "");
    }
  }

  static std::string NameOf(const Node& node) {
    if (node.op == Operator::kName) return Quoted(node.name);
    return node.op == Operator::kLiteral ? Describe(node.value) : "the value";
  }

  static std::string NameAndType(const Node& node) {
    const bool says_more = node.family == Family::kOther && node.type;
    return NameOf(node) + (says_more ? ", which is " + std::string(node.type->name) + "," : "");
  }

  void Problem(const Node& node, std::string message, std::string hint = {}) {
    problems_.push_back({node.offset, std::move(message), std::move(hint)});
  }

  Ast& ast_;
  ScriptNames& names_;
  const ScriptConstants& constants_;
  std::vector<ScriptProblem>& problems_;
};

}  // namespace

void Check(Ast& ast, ScriptNames& names, const ScriptConstants& constants,
           std::vector<ScriptProblem>& problems) {
  Checker(ast, names, constants, problems).Run();
}

}  // namespace coppice::script
