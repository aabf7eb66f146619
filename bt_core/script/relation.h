// How two operands of a script compare.
#ifndef COPPICE_BT_CORE_SCRIPT_RELATION_H_
#define COPPICE_BT_CORE_SCRIPT_RELATION_H_

#include <cstdint>

#include "bt_core/script/operand.h"

namespace coppice::script {

enum class Relation : std::uint8_t {
  kEqual,
  kNotEqual,
  kLess,
  kLessOrEqual,
  kGreater,
  kGreaterOrEqual
};

/// "==", "<" and so on.
const char* ToString(Relation relation);

/// Numbers, truth values (0 and 1) and enumerators compare as numbers, two texts by their bytes. A
/// text next to one of the others is read as one: '5' is 5, 'RED' is RED, '5x' is no number and so
/// equal to none. Values of other types are equal if they print the same text. Throws Failure if
/// there is no order between the two.
bool Holds(Relation relation, const Operand& a, const Operand& b);

/// The same of numbers of one type.
template <class T>
constexpr bool HoldsFor(Relation relation, T a, T b) {
  switch (relation) {
    case Relation::kEqual:
      return a == b;
    case Relation::kNotEqual:
      return a != b;
    case Relation::kLess:
      return a < b;
    case Relation::kLessOrEqual:
      return a <= b;
    case Relation::kGreater:
      return a > b;
    case Relation::kGreaterOrEqual:
      return a >= b;
  }
  return false;
}

}  // namespace coppice::script

#endif  // COPPICE_BT_CORE_SCRIPT_RELATION_H_
