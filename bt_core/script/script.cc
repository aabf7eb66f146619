#include "bt_core/script/script.h"

#include <algorithm>

#include "bt_core/script/ast.h"
#include "bt_core/script/checker.h"
#include "bt_core/script/code.h"
#include "bt_core/script/generator.h"
#include "bt_core/script/parser.h"
#include "bt_core/script/relation.h"

namespace coppice {
namespace {

using script::Code;
using script::Constant;
using script::Instruction;
using script::Op;
using script::Relation;

// How far an instruction of a condition gets without the interpreter.
enum class Answer : std::uint8_t { kNo, kYes, kNotHere };

Answer ToAnswer(bool yes) { return yes ? Answer::kYes : Answer::kNo; }

template <Relation kRelation>
Answer Compare(const Instruction& at, const Slot* slots, const Code& code) {
  const Value& value = slots[at.a].value;
  const Constant& constant = code.constants[at.b];
  if (value.Is<double>() && constant.is_exact) {
    return ToAnswer(script::HoldsFor(kRelation, value.Get<double>(), constant.number));
  }
  if (value.Is<std::int64_t>() && constant.value.kind == script::Operand::Kind::kInteger) {
    const std::int64_t integer = constant.value.integer;
    return ToAnswer(script::HoldsFor(kRelation, value.Get<std::int64_t>(), integer));
  }
  return Answer::kNotHere;
}

Answer IsTruth(const Value& value, bool truth) {
  return value.Is<bool>() ? ToAnswer(value.Get<bool>() == truth) : Answer::kNotHere;
}

Answer Ask(const Instruction& at, const Slot* slots, const Code& code) {
  switch (at.op) {
    case Op::kWhileEqual:
      return Compare<Relation::kEqual>(at, slots, code);
    case Op::kWhileNotEqual:
      return Compare<Relation::kNotEqual>(at, slots, code);
    case Op::kWhileLess:
      return Compare<Relation::kLess>(at, slots, code);
    case Op::kWhileLessOrEqual:
      return Compare<Relation::kLessOrEqual>(at, slots, code);
    case Op::kWhileGreater:
      return Compare<Relation::kGreater>(at, slots, code);
    case Op::kWhileGreaterOrEqual:
      return Compare<Relation::kGreaterOrEqual>(at, slots, code);
    case Op::kWhileSlot:
      return IsTruth(slots[at.a].value, true);
    case Op::kWhileNotSlot:
      return IsTruth(slots[at.a].value, false);
    default:
      return Answer::kNotHere;
  }
}

}  // namespace

std::optional<std::string> AddEnumerators(const EnumeratorList& list, ScriptConstants& constants) {
  std::optional<std::string> clash;
  for (const Enumerator& enumerator : list) {
    const auto [at, is_new] = constants.emplace(enumerator.name, enumerator.value);
    if (!is_new && at->second != enumerator.value && !clash) clash = at->first;
  }
  return clash;
}

std::optional<Script> Script::Compile(std::string_view text, ScriptNames& names,
                                      const ScriptConstants& constants,
                                      std::vector<ScriptProblem>& problems) {
  std::vector<ScriptProblem> found;
  std::optional<Script> script;
  if (text.size() > kMaxSize) {
    found.push_back({0, "the script is longer than " + std::to_string(kMaxSize) + " bytes", ""});
  } else {
    script::Ast ast = script::Parse(text, found);
    if (found.empty()) script::Check(ast, names, constants, found);
    if (found.empty()) {
      auto code = std::make_shared<const Code>(script::Generate(std::move(ast), text, found));
      if (found.empty()) script = Script(std::move(code));
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const ScriptProblem& a, const ScriptProblem& b) {
    return a.offset < b.offset;
  });
  problems.insert(problems.end(), found.begin(), found.end());
  return script;
}

void Script::Run(Blackboard& blackboard) const {
  script::Execute(*code_, code_->instructions.data(), blackboard.data());
}

// Conditions on doubles, integers of 64 bits and truth values are decided here; everything else,
// errors among it, is left to the interpreter.
bool Script::Test(Blackboard& blackboard) const {
  const Code& code = *code_;
  Slot* const slots = blackboard.data();
  const Instruction* at = code.instructions.data() + code.test;
  while (true) {
    if (at->op == Op::kReturnTrue) return true;
    if (at->op == Op::kReturnFalse) return false;
    const Answer answer = Ask(*at, slots, code);
    if (answer == Answer::kNotHere) return script::Execute(code, at, slots);
    at += answer == Answer::kYes ? 1 : at->jump + 1;
  }
}

const std::vector<SlotIndex>& Script::reads() const { return code_->reads; }
const std::vector<SlotIndex>& Script::writes() const { return code_->writes; }

}  // namespace coppice
