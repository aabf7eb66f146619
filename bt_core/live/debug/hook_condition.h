// The condition of a hook: a script that is compiled while the tree runs.
#ifndef COPPICE_BT_CORE_LIVE_DEBUG_HOOK_CONDITION_H_
#define COPPICE_BT_CORE_LIVE_DEBUG_HOOK_CONDITION_H_

#include <string_view>

#include "bt_core/base/outcome.h"
#include "bt_core/engine/program.h"

namespace coppice {

// A problem begins with its place in the condition:
// "condition:1:12: no node around here uses a key "batery" (did you mean "battery"?)".

/// A problem: it cannot be read, it writes, or it names a key that nodes of the scope do not have.
Expected<Script> CompileCondition(std::string_view text, const Program& program, ScopeIndex scope);

/// Whether it can be read at all, for a place that there is not yet: any name will do.
Outcome CheckCondition(std::string_view text, const ScriptConstants& constants);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DEBUG_HOOK_CONDITION_H_
