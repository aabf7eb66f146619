// Most scripts are guards: a few comparisons that are asked in every tick. So a comparison of a
// slot with a constant becomes one instruction, && and || become jumps, and what a guard answers is
// returned from where it is known. The code is made twice, once for Run and once for Test, because
// a run does not want the value of the last statement.
#include "bt_core/script/generator.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace coppice::script {
namespace {

using Kind = Operand::Kind;

Op CodeOf(Operator op) {
  switch (op) {
    case Operator::kBitOr:
      return Op::kBitOr;
    case Operator::kBitXor:
      return Op::kBitXor;
    case Operator::kBitAnd:
      return Op::kBitAnd;
    case Operator::kAdd:
    case Operator::kAddTo:
      return Op::kAdd;
    case Operator::kSubtract:
    case Operator::kSubtractFrom:
      return Op::kSubtract;
    case Operator::kJoin:
      return Op::kJoin;
    case Operator::kMultiply:
    case Operator::kMultiplyBy:
      return Op::kMultiply;
    case Operator::kDivide:
    case Operator::kDivideBy:
      return Op::kDivide;
    case Operator::kRemainder:
      return Op::kRemainder;
    case Operator::kNegate:
      return Op::kNegate;
    case Operator::kComplement:
      return Op::kComplement;
    case Operator::kAbsolute:
      return Op::kAbsolute;
    case Operator::kMin:
      return Op::kMin;
    case Operator::kMax:
      return Op::kMax;
    default:
      return Op::kClamp;
  }
}

Op Shifted(Op first, Relation relation) {
  return static_cast<Op>(static_cast<int>(first) + static_cast<int>(relation));
}

Relation Mirrored(Relation relation) {
  switch (relation) {
    case Relation::kLess:
      return Relation::kGreater;
    case Relation::kLessOrEqual:
      return Relation::kGreaterOrEqual;
    case Relation::kGreater:
      return Relation::kLess;
    case Relation::kGreaterOrEqual:
      return Relation::kLessOrEqual;
    default:
      return relation;
  }
}

double ToDouble(const Operand& operand) {
  const Operand number = ToNumber(operand);
  return number.kind == Kind::kInteger ? static_cast<double>(number.integer) : number.number;
}

bool IsPlainAssignment(Operator op) { return op == Operator::kCreate || op == Operator::kAssign; }

class Generator {
 public:
  Generator(Ast ast, std::string_view script, std::vector<ScriptProblem>& problems)
      : ast_(std::move(ast)), problems_(problems) {
    code_.text = script;
    code_.types = {nullptr};
  }

  Code Run() {
    for (const NodeId statement : ast_.statements) Effect(statement);
    Emit({Op::kReturnTrue}, 0);
    code_.test = static_cast<std::uint32_t>(code_.instructions.size());
    for (std::size_t i = 0; i + 1 < ast_.statements.size(); ++i) Effect(ast_.statements[i]);
    Result(ast_.statements.back());
    ListSlots();
    code_.texts = std::move(ast_.texts);
    return std::move(code_);
  }

 private:
  using Jumps = std::vector<std::size_t>;  // numbers of instructions whose goal is not known yet
  using Register = std::uint16_t;

  const Node& At(NodeId id) const { return ast_.nodes[id]; }

  std::size_t Emit(Instruction instruction, std::uint32_t offset) {
    code_.instructions.push_back(instruction);
    code_.offsets.push_back(offset);
    return code_.instructions.size() - 1;
  }

  void LandHere(const Jumps& jumps) {
    for (const std::size_t jump : jumps) {
      code_.instructions[jump].jump = static_cast<std::uint32_t>(code_.instructions.size() - jump);
    }
  }

  Register After(Register to, const Node& node) {
    if (to + 3U < kRegisters) return to + 1;
    const bool reported = !problems_.empty();
    if (!reported) {
      problems_.push_back({node.offset, "this expression is nested too deeply",
                           "split it into several statements"});
    }
    return to;
  }

  std::uint32_t ConstantOf(const Operand& value) {
    code_.constants.push_back({value, value.kind == Kind::kText ? 0 : ToDouble(value)});
    return static_cast<std::uint32_t>(code_.constants.size() - 1);
  }

  std::uint32_t NumberOf(const Type* type) {
    const auto found = std::find(code_.types.begin(), code_.types.end(), type);
    const auto number = static_cast<std::uint32_t>(found - code_.types.begin());
    if (found == code_.types.end()) code_.types.push_back(type);
    return number;
  }

  // A statement whose value nobody wants.
  void Effect(NodeId statement) {
    Begin(statement);
    if (IsAssignment(At(statement).op)) {
      Assign(At(statement), 0);
    } else {
      Evaluate(statement, 0);
    }
  }

  // A text that was read before an assignment could change under the hands of an operator. Not so
  // in a := b := c, where nothing was read before.
  void Begin(NodeId statement) {
    NodeId rest = statement;
    while (IsPlainAssignment(At(rest).op)) rest = At(rest).operands[1];
    const bool compound = IsAssignment(At(rest).op);
    copies_texts_ = HasAssignment(compound ? At(rest).operands[1] : rest);
  }

  bool HasAssignment(NodeId id) const {
    const Node& node = At(id);
    const auto has = [this](NodeId operand) { return HasAssignment(operand); };
    return IsAssignment(node.op) || std::any_of(node.operands.begin(), node.operands.end(), has);
  }

  void Result(NodeId node) {
    Begin(node);
    Jumps falses;
    Return(node, falses);
    LandHere(falses);
    Emit({Op::kReturnFalse}, 0);
  }

  // Returns whether the expression is true, or jumps if it is false.
  void Return(NodeId id, Jumps& falses) {
    const Node& node = At(id);
    if (node.op == Operator::kAnd) {
      Test(node.operands[0], 0, falses);
      return Return(node.operands[1], falses);
    }
    if (const std::optional<Question> question = QuestionOf(id)) {
      Ask(*question, Op::kIsEqual);
      return;
    }
    Test(id, 0, falses);
    Emit({Op::kReturnTrue}, 0);
  }

  // What can be asked of a slot in one instruction.
  struct Question {
    int number;  // among the ten
    const Node* key;
    const Node* constant = nullptr;
  };

  std::size_t Ask(const Question& question, Op first) {
    const Op op = static_cast<Op>(static_cast<int>(first) + question.number);
    const std::uint32_t b = question.constant ? ConstantOf(question.constant->value) : 0;
    return Emit({op, 0, question.key->slot, b}, question.key->offset);
  }

  std::optional<Question> QuestionOf(NodeId id) const {
    constexpr int kTextEqual = 6;
    constexpr int kSlot = 8;
    constexpr int kNotSlot = 9;
    const Node& node = At(id);
    if (node.op == Operator::kName) return Question{kSlot, &node};
    if (node.op == Operator::kNot && At(node.operands[0]).op == Operator::kName) {
      return Question{kNotSlot, &At(node.operands[0])};
    }
    if (node.op != Operator::kCompare || node.relations.size() > 1) return std::nullopt;
    const Node* key = &At(node.operands[0]);
    const Node* constant = &At(node.operands[1]);
    const bool mirrored = key->op == Operator::kLiteral;
    if (mirrored) std::swap(key, constant);
    const Relation relation = mirrored ? Mirrored(node.relations[0]) : node.relations[0];
    const int number = static_cast<int>(relation);
    if (key->op != Operator::kName || constant->op != Operator::kLiteral) return std::nullopt;
    if (constant->value.kind == Kind::kText) {
      if (relation > Relation::kNotEqual) return std::nullopt;
      return Question{kTextEqual + number, key, constant};
    }
    const Operand rounded = Operand::Double(ToDouble(constant->value));
    if (!Holds(Relation::kEqual, rounded, constant->value)) return std::nullopt;
    return Question{number, key, constant};
  }

  // Goes on if the expression is true; the jumps that are made if it is false go to `falses`.
  void Test(NodeId id, Register to, Jumps& falses) {
    if (const std::optional<Question> question = QuestionOf(id)) {
      falses.push_back(Ask(*question, Op::kWhileEqual));
      return;
    }
    const Node& node = At(id);
    switch (node.op) {
      case Operator::kAnd:
        Test(node.operands[0], to, falses);
        return Test(node.operands[1], to, falses);
      case Operator::kOr:
        return TestEither(node, to, falses);
      case Operator::kNot:
        return TestNot(node, to, falses);
      case Operator::kCompare:
        return TestChain(node, to, falses);
      default:
        Evaluate(id, to);
        falses.push_back(Emit({Op::kWhile, to}, node.offset));
    }
  }

  void TestEither(const Node& node, Register to, Jumps& falses) {
    Jumps first;
    Test(node.operands[0], to, first);
    const std::size_t done = Emit({Op::kJump}, node.offset);
    LandHere(first);
    Test(node.operands[1], to, falses);
    LandHere({done});
  }

  void TestNot(const Node& node, Register to, Jumps& falses) {
    Jumps inner;
    Test(node.operands[0], to, inner);
    falses.push_back(Emit({Op::kJump}, node.offset));
    LandHere(inner);
  }

  void TestChain(const Node& node, Register to, Jumps& falses) {
    const Register next = After(to, node);
    Evaluate(node.operands[0], to);
    for (std::size_t i = 0; i < node.relations.size(); ++i) {
      if (i > 0) Emit({Op::kMove, to, next}, node.offset);
      Evaluate(node.operands[i + 1], next);
      Emit({Shifted(Op::kEqual, node.relations[i]), to}, node.offset);
      falses.push_back(Emit({Op::kWhile, to}, node.offset));
    }
  }

  void Evaluate(NodeId id, Register to) {
    const Node& node = At(id);
    switch (node.op) {
      case Operator::kLiteral:
        Emit({Op::kLoadConstant, to, ConstantOf(node.value)}, node.offset);
        return;
      case Operator::kName:
        return Load(node, to);
      case Operator::kChoose:
        return Choose(node, to);
      case Operator::kOr:
      case Operator::kAnd:
      case Operator::kNot:
      case Operator::kCompare:
        return EvaluateTruth(id, to);
      default:
        if (!IsAssignment(node.op)) return Compute(node, to);
        Assign(node, to);
        Load(At(node.operands[0]), to);
    }
  }

  void Load(const Node& name, Register to) {
    Emit({copies_texts_ ? Op::kLoadSlotCopy : Op::kLoadSlot, to, name.slot}, name.offset);
  }

  void Choose(const Node& node, Register to) {
    Jumps falses;
    Test(node.operands[0], to, falses);
    Evaluate(node.operands[1], to);
    const std::size_t done = Emit({Op::kJump}, node.offset);
    LandHere(falses);
    Evaluate(node.operands[2], to);
    LandHere({done});
  }

  void EvaluateTruth(NodeId id, Register to) {
    const std::uint32_t offset = At(id).offset;
    Jumps falses;
    Test(id, to, falses);
    Emit({Op::kLoadConstant, to, ConstantOf(Operand::Bool(true))}, offset);
    const std::size_t done = Emit({Op::kJump}, offset);
    LandHere(falses);
    Emit({Op::kLoadConstant, to, ConstantOf(Operand::Bool(false))}, offset);
    LandHere({done});
  }

  void Compute(const Node& node, Register to) {
    const Instruction instruction = {CodeOf(node.op), to};
    const bool folds = node.operands.size() > 1 && node.op != Operator::kClamp;  // min(a, b, c)
    Evaluate(node.operands[0], to);
    Register next = to;
    for (std::size_t i = 1; i < node.operands.size(); ++i) {
      next = After(folds ? to : next, node);
      Evaluate(node.operands[i], next);
      if (folds) Emit(instruction, node.offset);
    }
    if (!folds) Emit(instruction, node.offset);
  }

  void Assign(const Node& node, Register to) {
    const Node& key = At(node.operands[0]);
    const bool compound = !IsPlainAssignment(node.op);
    if (compound) Load(key, to);
    const Register value = compound ? After(to, node) : to;
    Evaluate(node.operands[1], value);
    if (compound) Emit({CodeOf(node.op), to}, node.offset);
    const Op store = node.op == Operator::kCreate ? Op::kStore : Op::kStoreExisting;
    Emit({store, to, key.slot, NumberOf(key.type)}, key.offset);
  }

  void ListSlots() {
    for (const Node& node : ast_.nodes) {
      if (node.op == Operator::kName && !node.is_target) code_.reads.push_back(node.slot);
      if (!IsAssignment(node.op)) continue;
      const SlotIndex slot = At(node.operands[0]).slot;
      code_.writes.push_back(slot);
      if (!IsPlainAssignment(node.op)) code_.reads.push_back(slot);
    }
    for (std::vector<SlotIndex>* slots : {&code_.reads, &code_.writes}) {
      std::sort(slots->begin(), slots->end());
      slots->erase(std::unique(slots->begin(), slots->end()), slots->end());
    }
  }

  Ast ast_;
  std::vector<ScriptProblem>& problems_;
  Code code_;
  bool copies_texts_ = false;  // in this statement
};

}  // namespace

Code Generate(Ast ast, std::string_view script, std::vector<ScriptProblem>& problems) {
  return Generator(std::move(ast), script, problems).Run();
}

}  // namespace coppice::script
