// Hooks and stops of the Debugger as JSON, for the extension of the live protocol.
#ifndef COPPICE_BT_CORE_LIVE_DEBUG_HOOK_JSON_H_
#define COPPICE_BT_CORE_LIVE_DEBUG_HOOK_JSON_H_

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bt_core/live/debug/debugger_hooks.h"

namespace coppice {

class Program;

/// Throws std::exception with a text for people.
Hook ReadHook(const nlohmann::json& json);
Status ReadStatus(const std::string& name);

nlohmann::json WriteHook(const HookInfo& info, bool is_mine);
/// null if the tree is not stopped.
nlohmann::json WriteStop(const DebugStop& stop, const Program& program);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DEBUG_HOOK_JSON_H_
