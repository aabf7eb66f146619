// Which nodes of a tree a hook means.
#ifndef COPPICE_BT_CORE_LIVE_DEBUG_HOOK_NODES_H_
#define COPPICE_BT_CORE_LIVE_DEBUG_HOOK_NODES_H_

#include <string>
#include <string_view>
#include <vector>

#include "bt_core/engine/program.h"

namespace coppice {

/// The nodes that bear the path, in ascending order (see Hook::path).
std::vector<NodeIndex> FindNodes(const Program& program, std::string_view path);

/// "no node ... in the present tree (did you mean ...?)"
std::string DescribeMissingNode(const Program& program, std::string_view path);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DEBUG_HOOK_NODES_H_
