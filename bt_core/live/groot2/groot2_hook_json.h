// Hooks as the Groot2 protocol wants them from a client.
#ifndef COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_HOOK_JSON_H_
#define COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_HOOK_JSON_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/outcome.h"
#include "bt_core/frames/tree_description.h"
#include "bt_core/live/debug/debugger_hooks.h"

namespace coppice::groot2 {

/// Whether the protocol can say all of this hook.
Outcome CheckHook(const Hook& hook);

std::string WriteHookInsert(const Hook& hook, std::uint16_t uid);
std::string WriteHookRemove(std::uint16_t uid, HookPosition position);
std::string WriteUnlock(std::uint16_t uid, HookPosition position, std::optional<Status> result);

struct ListedHook {
  std::uint16_t uid = 0;
  Hook hook;  ///< without its node
};
/// The answer to HOOKS_DUMP, any bytes; what is no hook is passed over, and so is what comes after
/// the first thousand.
std::vector<ListedHook> ReadHooks(std::string_view json);

/// The nodes of a path (Hook::path).
std::vector<NodeIndex> FindNodes(const TreeDescription& tree, std::string_view path);

}  // namespace coppice::groot2

#endif  // COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_HOOK_JSON_H_
