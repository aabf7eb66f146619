// Scripts run in every tick, so a run allocates nothing: registers and the texts that it makes lie
// on the stack, and only texts that are too long for that go to the heap. One switch over the
// instructions, those of guards first, is enough: the generator makes few of them. Errors are
// exceptions, so what does not fail pays nothing for them.
#include <charconv>
#include <cstring>
#include <forward_list>
#include <string>

#include "bt_core/script/code.h"
#include "bt_core/script/relation.h"
#include "bt_core/script/script.h"
#include "bt_core/script/store.h"

namespace coppice::script {
namespace {

using Kind = Operand::Kind;

constexpr std::size_t kMaxText = 1 << 20;  // one that joins itself in every tick fills the memory

// Keeps the texts that a run makes; short ones without allocation.
class Scratch {
 public:
  std::string_view Keep(std::string_view first, std::string_view second = {}) {
    const std::size_t size = first.size() + second.size();
    if (size > kMaxText && !second.empty()) {
      throw Failure{"a text of " + std::to_string(size) + " bytes; scripts join texts up to " +
                    std::to_string(kMaxText)};
    }
    if (size > sizeof(characters_) - used_) {
      long_.emplace_front(first);
      return long_.front().append(second);
    }
    char* const at = characters_ + used_;
    used_ += size;
    if (!first.empty()) std::memcpy(at, first.data(), first.size());
    if (!second.empty()) std::memcpy(at + first.size(), second.data(), second.size());
    return {at, size};
  }

  /// As a person writes it: 3.0 is 3, 'text' is text.
  std::string_view Print(const Operand& operand) {
    switch (operand.kind) {
      case Kind::kText:
        return operand.text();
      case Kind::kInteger: {
        char digits[24];
        return Keep(
            {digits, static_cast<std::size_t>(
                         std::to_chars(digits, std::end(digits), operand.integer).ptr - digits)});
      }
      case Kind::kOther:
        return Keep(operand.other->Print());
      case Kind::kBool:
      case Kind::kDouble:
        break;
    }
    return Keep(Describe(operand));
  }

 private:
  char characters_[1024];
  std::size_t used_ = 0;
  std::forward_list<std::string> long_;
};

// The registers and what the instructions do with them.
class Machine {
 public:
  Machine(const Code& code, Blackboard& blackboard)
      : code_(code), slots_(blackboard.data()), now_(blackboard.now()) {}

  // The instruction at work; where it is when something is thrown is where the error is.
  const Instruction* at = nullptr;

  bool Run(const Instruction* start) {
    for (at = start;; ++at) {
      switch (at->op) {
        case Op::kReturnTrue:
          return true;
        case Op::kReturnFalse:
          return false;
        case Op::kWhileEqual:
        case Op::kWhileNotEqual:
        case Op::kWhileLess:
        case Op::kWhileLessOrEqual:
        case Op::kWhileGreater:
        case Op::kWhileGreaterOrEqual:
        case Op::kWhileTextEqual:
        case Op::kWhileTextNotEqual:
        case Op::kWhileSlot:
        case Op::kWhileNotSlot:
          JumpUnless(Ask(Op::kWhileEqual));
          break;
        case Op::kIsEqual:
        case Op::kIsNotEqual:
        case Op::kIsLess:
        case Op::kIsLessOrEqual:
        case Op::kIsGreater:
        case Op::kIsGreaterOrEqual:
        case Op::kIsTextEqual:
        case Op::kIsTextNotEqual:
        case Op::kIsSlot:
        case Op::kIsNotSlot:
          return Ask(Op::kIsEqual);
        case Op::kWhile:
          JumpUnless(IsTrue(Here()));
          break;
        case Op::kJump:
          JumpUnless(false);
          break;
        case Op::kLoadConstant:
          Here() = code_.constants[at->a].value;
          break;
        case Op::kLoadSlot:
          Here() = Load();
          break;
        case Op::kLoadSlotCopy:
          Here() = Load();
          if (Here().kind == Kind::kText) Here() = Operand::Text(scratch_.Keep(Here().text()));
          break;
        case Op::kMove:
          Here() = registers_[at->a];
          break;
        case Op::kStore:
          StoreHere(true);
          break;
        case Op::kStoreExisting:
          StoreHere(false);
          break;
        case Op::kNegate:
          Here() = Negate(Here());
          break;
        case Op::kComplement:
          Here() = Complement(Here());
          break;
        case Op::kAbsolute:
          Here() = Absolute(Here());
          break;
        case Op::kAdd:
          AddHere();
          break;
        case Op::kSubtract:
          Here() = Subtract(Here(), Next());
          break;
        case Op::kMultiply:
          Here() = Multiply(Here(), Next());
          break;
        case Op::kDivide:
          Here() = Divide(Here(), Next());
          break;
        case Op::kRemainder:
          Here() = Remainder(Here(), Next());
          break;
        case Op::kJoin:
          Join();
          break;
        case Op::kBitAnd:
          Here() = BitAnd(Here(), Next());
          break;
        case Op::kBitOr:
          Here() = BitOr(Here(), Next());
          break;
        case Op::kBitXor:
          Here() = BitXor(Here(), Next());
          break;
        case Op::kMin:
          Here() = Min(Here(), Next());
          break;
        case Op::kMax:
          Here() = Max(Here(), Next());
          break;
        case Op::kClamp:
          Here() = Clamp(Here(), Next(), registers_[at->to + 2]);
          break;
        case Op::kEqual:
        case Op::kNotEqual:
        case Op::kLess:
        case Op::kLessOrEqual:
        case Op::kGreater:
        case Op::kGreaterOrEqual:
          Here() =
              Operand::Bool(Holds(static_cast<Relation>(NumberFrom(Op::kEqual)), Here(), Next()));
          break;
      }
    }
  }

 private:
  Operand& Here() { return registers_[at->to]; }
  const Operand& Next() const { return registers_[at->to + 1]; }

  int NumberFrom(Op first) const { return static_cast<int>(at->op) - static_cast<int>(first); }

  // `first` is the first of the ten questions.
  bool Ask(Op first) const {
    constexpr int kRelations = 6;
    const int question = NumberFrom(first);
    if (question >= 8) return IsTrue(Load()) == (question == 8);
    const int relation = question < kRelations ? question : question - kRelations;
    return Holds(static_cast<Relation>(relation), Load(), code_.constants[at->b].value);
  }

  void JumpUnless(bool holds) {
    if (!holds) at += at->jump - 1;
  }

  Operand Load() const {
    const Value& value = slots_[at->a].value;
    if (!value.has_value()) throw Failure{"it has no value yet"};
    return OperandOf(value);
  }

  void StoreHere(bool create) {
    Slot& slot = slots_[at->a];
    const Type* const type = code_.types[at->b];
    if (!create && !type && !slot.value.has_value()) {
      throw Failure{"it has no value yet; := creates it"};
    }
    Store(Here(), type, slot, now_);
  }

  void AddHere() {
    const bool texts = Here().kind == Kind::kText && Next().kind == Kind::kText;
    if (texts) return Join();
    if (Here().kind == Kind::kText || Next().kind == Kind::kText) {
      throw Failure{"+ adds two numbers or joins two texts; .. joins " + Describe(Here()) +
                    " and " + Describe(Next())};
    }
    Here() = Add(Here(), Next());
  }

  void Join() {
    const std::string_view first = scratch_.Print(Here());
    Here() = Operand::Text(scratch_.Keep(first, scratch_.Print(Next())));
  }

  const Code& code_;
  Slot* slots_;
  const Time now_;
  Scratch scratch_;
  Operand registers_[kRegisters];
};

bool NamesSlot(Op op) {
  return op <= Op::kIsNotSlot || (op >= Op::kLoadSlot && op <= Op::kStoreExisting);
}

[[noreturn]] void Throw(const Code& code, const Instruction& at, const Failure& failure) {
  const std::uint32_t offset = code.offsets[&at - code.instructions.data()];
  std::string message = "script \"" + code.text + "\", at character " + std::to_string(offset + 1);
  if (NamesSlot(at.op)) message += ", key \"" + std::string(KeyAt(code.text, offset)) + "\"";
  throw ScriptError(message + ": " + failure.message);
}

}  // namespace

std::string_view KeyAt(std::string_view script, std::uint32_t offset) {
  constexpr std::string_view kEnds = " \t\r\n+-*/%&|^~!<>=?:();,.'\"";
  const std::string_view rest = script.substr(offset);
  return rest.substr(0, rest.find_first_of(kEnds));
}

bool Execute(const Code& code, const Instruction* at, Blackboard& blackboard) {
  Machine machine(code, blackboard);
  try {
    return machine.Run(at);
  } catch (const Failure& failure) {
    Throw(code, *machine.at, failure);
  }
}

}  // namespace coppice::script
