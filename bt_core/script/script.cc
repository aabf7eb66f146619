#include "bt_core/script/script.h"

#include <algorithm>

#include "bt_core/script/ast.h"
#include "bt_core/script/checker.h"
#include "bt_core/script/code.h"
#include "bt_core/script/doubts.h"
#include "bt_core/script/generator.h"
#include "bt_core/script/parser.h"
#include "bt_core/script/relation.h"

namespace coppice {
namespace {

using script::Code;
using script::Constant;
using script::Instruction;
using script::Op;
using script::Operand;
using script::Relation;

// The answer to a question of a condition, if it takes no interpreter.
enum class Answer : std::uint8_t { kNo, kYes, kUnknown };

Answer ToAnswer(bool yes) { return yes ? Answer::kYes : Answer::kNo; }

template <Relation kRelation>
Answer Compare(const Value& value, const Constant& constant) {
  if (value.Is<double>()) {
    return ToAnswer(script::HoldsFor(kRelation, value.Get<double>(), constant.number));
  }
  if (value.Is<std::int64_t>() && constant.value.kind == Operand::Kind::kInteger) {
    const std::int64_t integer = constant.value.integer;
    return ToAnswer(script::HoldsFor(kRelation, value.Get<std::int64_t>(), integer));
  }
  return Answer::kUnknown;
}

Answer IsText(const Value& value, const Constant& constant, bool expected) {
  if (!value.Is<std::string>()) return Answer::kUnknown;
  const std::string& text = value.Get<std::string>();
  const Operand& other = constant.value;
  bool same = text.size() == other.size;
  // Byte by byte: a call would make the loop of Test save its registers.
  for (std::uint32_t i = 0; same && i < other.size; ++i) same = text[i] == other.characters[i];
  return ToAnswer(same == expected);
}

Answer IsTruth(const Value& value, bool expected) {
  return value.Is<bool>() ? ToAnswer(value.Get<bool>() == expected) : Answer::kUnknown;
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
                                      std::vector<ScriptProblem>& problems, ScriptUse use) {
  std::vector<ScriptProblem> found;
  std::vector<ScriptProblem> doubts;
  std::optional<Script> script;
  if (text.size() > kMaxSize) {
    found.push_back({0, "the script is longer than " + std::to_string(kMaxSize) + " bytes", ""});
  } else {
    script::Ast ast = script::Parse(text, found);
    if (found.empty()) script::Check(ast, names, constants, found);
    if (found.empty()) {
      if (use == ScriptUse::kCondition) script::AddDoubts(ast, doubts);
      auto code = std::make_shared<const Code>(script::Generate(std::move(ast), text, found));
      if (found.empty()) script = Script(std::move(code));
    }
  }
  found.insert(found.end(), doubts.begin(), doubts.end());
  std::stable_sort(found.begin(), found.end(), [](const ScriptProblem& a, const ScriptProblem& b) {
    return a.offset < b.offset;
  });
  problems.insert(problems.end(), found.begin(), found.end());
  return script;
}

void Script::Run(Blackboard& blackboard) const {
  script::Execute(*code_, code_->instructions.data(), blackboard);
}

// Conditions on doubles, integers of 64 bits, texts and truth values are decided here; everything
// else, errors among it, is left to the interpreter.
bool Script::Test(Blackboard& blackboard) const {
  const Constant* const constants = code_->constants.data();
  Slot* const slots = blackboard.data();
  const Instruction* at = test_;
  const auto value = [&]() -> const Value& { return slots[at->a].value; };
  const auto constant = [&]() -> const Constant& { return constants[at->b]; };
  // Goes on at the next question; false if the interpreter must answer this one. At each question
  // by itself: one place for all of them costs a fifth more.
  const auto go_on = [&](Answer answer) {
    if (answer == Answer::kUnknown) return false;
    at += answer == Answer::kYes ? 1 : at->jump;
    return true;
  };
  while (true) {
    Answer answer = Answer::kUnknown;
    switch (at->op) {
      case Op::kReturnTrue:
        return true;
      case Op::kReturnFalse:
        return false;
      case Op::kWhileEqual:
        if (go_on(Compare<Relation::kEqual>(value(), constant()))) continue;
        break;
      case Op::kWhileNotEqual:
        if (go_on(Compare<Relation::kNotEqual>(value(), constant()))) continue;
        break;
      case Op::kWhileLess:
        if (go_on(Compare<Relation::kLess>(value(), constant()))) continue;
        break;
      case Op::kWhileLessOrEqual:
        if (go_on(Compare<Relation::kLessOrEqual>(value(), constant()))) continue;
        break;
      case Op::kWhileGreater:
        if (go_on(Compare<Relation::kGreater>(value(), constant()))) continue;
        break;
      case Op::kWhileGreaterOrEqual:
        if (go_on(Compare<Relation::kGreaterOrEqual>(value(), constant()))) continue;
        break;
      case Op::kWhileTextEqual:
        if (go_on(IsText(value(), constant(), true))) continue;
        break;
      case Op::kWhileTextNotEqual:
        if (go_on(IsText(value(), constant(), false))) continue;
        break;
      case Op::kWhileSlot:
        if (go_on(IsTruth(value(), true))) continue;
        break;
      case Op::kWhileNotSlot:
        if (go_on(IsTruth(value(), false))) continue;
        break;
      case Op::kIsEqual:
        answer = Compare<Relation::kEqual>(value(), constant());
        break;
      case Op::kIsNotEqual:
        answer = Compare<Relation::kNotEqual>(value(), constant());
        break;
      case Op::kIsLess:
        answer = Compare<Relation::kLess>(value(), constant());
        break;
      case Op::kIsLessOrEqual:
        answer = Compare<Relation::kLessOrEqual>(value(), constant());
        break;
      case Op::kIsGreater:
        answer = Compare<Relation::kGreater>(value(), constant());
        break;
      case Op::kIsGreaterOrEqual:
        answer = Compare<Relation::kGreaterOrEqual>(value(), constant());
        break;
      case Op::kIsTextEqual:
        answer = IsText(value(), constant(), true);
        break;
      case Op::kIsTextNotEqual:
        answer = IsText(value(), constant(), false);
        break;
      case Op::kIsSlot:
        answer = IsTruth(value(), true);
        break;
      case Op::kIsNotSlot:
        answer = IsTruth(value(), false);
        break;
      default:
        break;
    }
    if (answer == Answer::kUnknown) return script::Execute(*code_, at, blackboard);
    return answer == Answer::kYes;
  }
}

Script::Script(std::shared_ptr<const Code> code)
    : code_(std::move(code)), test_(code_->instructions.data() + code_->test) {}

const std::vector<SlotIndex>& Script::reads() const { return code_->reads; }
const std::vector<SlotIndex>& Script::writes() const { return code_->writes; }

}  // namespace coppice
