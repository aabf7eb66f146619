// The condition of a hook: a script that is compiled while the tree runs.
#ifndef COPPICE_BT_CORE_LIVE_DEBUG_HOOK_CONDITION_H_
#define COPPICE_BT_CORE_LIVE_DEBUG_HOOK_CONDITION_H_

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "bt_core/engine/program.h"

namespace coppice {

/// What is wrong with a condition, and where in its text, in bytes.
struct ConditionProblem {
  std::string text;  ///< "1:12: no key \"batery\" here (did you mean "battery"?)"; empty: nothing
  std::size_t offset = std::string::npos;
};

/// Nothing if there is a problem: it cannot be read, it writes, or it names a key that nodes of the
/// scope do not have.
std::optional<Script> CompileCondition(std::string_view text, const Program& program,
                                       ScopeIndex scope, ConditionProblem& problem);

/// Whether it can be read at all, for a place that there is not yet: any name will do.
ConditionProblem CheckCondition(std::string_view text, const ScriptConstants& constants);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DEBUG_HOOK_CONDITION_H_
