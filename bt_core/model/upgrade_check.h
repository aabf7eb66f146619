// BlackboardCheckInt, -Double, -String and -Bool, decorators of format 3 that format 4 has no more.
#ifndef COPPICE_BT_CORE_MODEL_UPGRADE_CHECK_H_
#define COPPICE_BT_CORE_MODEL_UPGRADE_CHECK_H_

#include <string_view>

#include "bt_core/model/document.h"

namespace coppice {

bool IsBlackboardCheck(std::string_view type);

/// True if a script can read a key of that name: letters, digits and underscores.
bool IsKey(std::string_view name);

/// Makes
///   <BlackboardCheckInt value_A="{a}" value_B="3" return_on_mismatch="FAILURE"> child
/// a ReactiveSequence of <ScriptCondition code="a == 3"/> and the child. Like the check, it
/// compares on every tick and halts a running child. For SUCCESS it becomes a ReactiveFallback of
/// the opposite condition. Where that cannot be, the edit is empty and a warning says why.
Edit UpgradeBlackboardCheck(const Document& document, ElementIndex element, std::string_view type,
                            Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_UPGRADE_CHECK_H_
