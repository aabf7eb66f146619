// What a script is compiled to: instructions for a machine with a few registers, whose memory are
// the slots of the blackboard. Jumps lead forward only, so a script ends.
//
// The commonest conditions, a slot against a number and a slot that is true or false, are one
// instruction each and use no register.
#ifndef COPPICE_BT_CORE_SCRIPT_CODE_H_
#define COPPICE_BT_CORE_SCRIPT_CODE_H_

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/data/blackboard.h"
#include "bt_core/script/operand.h"

namespace coppice::script {

enum class Op : std::uint16_t {
  kReturnTrue,
  kReturnFalse,
  // The questions: how the slot `a` compares with the constant `b`, a number or a text, or whether
  // it is true or not. Goes on if the answer is yes, else jumps.
  kWhileEqual,
  kWhileNotEqual,
  kWhileLess,
  kWhileLessOrEqual,
  kWhileGreater,
  kWhileGreaterOrEqual,
  kWhileTextEqual,
  kWhileTextNotEqual,
  kWhileSlot,
  kWhileNotSlot,
  // The same questions; returns the answer.
  kIsEqual,
  kIsNotEqual,
  kIsLess,
  kIsLessOrEqual,
  kIsGreater,
  kIsGreaterOrEqual,
  kIsTextEqual,
  kIsTextNotEqual,
  kIsSlot,
  kIsNotSlot,
  kWhile,  // goes on if the register `to` is true, else jumps
  kJump,
  kLoadConstant,   // `to` = constant `a`
  kLoadSlot,       // `to` = slot `a`
  kLoadSlotCopy,   // the same; a text does not change when the slot does
  kMove,           // `to` = register `a`
  kStore,          // slot `a` = `to`, of type number `b`
  kStoreExisting,  // the same; the slot must have a value or a type
  // `to` = operator on `to`
  kNegate,
  kComplement,
  kAbsolute,
  // `to` = operator on `to` and the next register, of kClamp the next two
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kRemainder,
  kJoin,
  kBitAnd,
  kBitOr,
  kBitXor,
  kMin,
  kMax,
  kClamp,
  kEqual,
  kNotEqual,
  kLess,
  kLessOrEqual,
  kGreater,
  kGreaterOrEqual,
};

struct Instruction {
  Op op;
  std::uint16_t to = 0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t jump = 0;  ///< how many instructions further; at least 1
};
static_assert(sizeof(Instruction) == 16);

struct Constant {
  Operand value;
  double number;  ///< of a number; the same one, if slots are compared with it
};

inline constexpr std::uint32_t kRegisters = 128;

struct Code {
  std::vector<Instruction> instructions;  ///< as Script::Run wants them, then from `test` on
                                          ///< as Script::Test does
  std::uint32_t test = 0;
  std::vector<Constant> constants;
  std::vector<const Type*> types;  ///< that ports give to assigned slots; the first is null
  std::vector<SlotIndex> reads;
  std::vector<SlotIndex> writes;

  // For messages, and to keep the texts of the constants.
  std::string text;
  std::vector<std::uint32_t> offsets;  ///< in the text, of each instruction
  std::deque<std::string> texts;
};

/// The key that is written at that offset in the text of the script.
std::string_view KeyAt(std::string_view script, std::uint32_t offset);

/// Runs from `at` on. Throws ScriptError.
bool Execute(const Code& code, const Instruction* at, Blackboard& blackboard);

}  // namespace coppice::script

#endif  // COPPICE_BT_CORE_SCRIPT_CODE_H_
