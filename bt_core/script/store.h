// Assignment of the result of an expression to a slot.
#ifndef COPPICE_BT_CORE_SCRIPT_STORE_H_
#define COPPICE_BT_CORE_SCRIPT_STORE_H_

#include "bt_core/data/blackboard.h"
#include "bt_core/script/operand.h"

namespace coppice::script {

/// Writes and counts the write. `type` is what ports give to the slot; the value becomes one of
/// that type; a number or enumerator becomes its text if it is string. Without a type, the first
/// value gives the slot one, and later ones become values of it; a number that is not kept by that
/// turns the slot into a wider type (bool, integer, double). A text is read as a value of the type.
/// Throws Failure and leaves the slot as it is if none of this can be done.
void Store(const Operand& operand, const Type* type, Slot& slot, Time now);

}  // namespace coppice::script

#endif  // COPPICE_BT_CORE_SCRIPT_STORE_H_
