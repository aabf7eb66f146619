// A running tree as the XML text that a live view asks for first.
#ifndef COPPICE_BT_CORE_LIVE_GROOT2_FULL_TREE_H_
#define COPPICE_BT_CORE_LIVE_GROOT2_FULL_TREE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/engine/program.h"

namespace coppice {

/// As long as a client reads [bytes].
inline constexpr std::size_t kLongestFullTree = std::size_t{16} << 20;

/// One <BehaviorTree ID _fullpath> for each instance of a tree, the main tree first; a SubTree is
/// an element without children that is joined to its instance by _fullpath. Every element bears its
/// number as _uid, its name and its ports as they are written. Then the <TreeNodesModel> of all
/// registered node types. Nothing if that is longer than kLongestFullTree: trees and what stands
/// in them are written again for each instance.
std::optional<std::string> WriteFullTree(const Program& program);

/// The number of a node in the protocol: node + 1.
inline std::uint16_t Uid(NodeIndex node) { return static_cast<std::uint16_t>(node + 1); }

/// All nodes, instance by instance, each in preorder: the order of the protocol's status list.
std::vector<NodeIndex> NodesByInstance(const Program& program);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_GROOT2_FULL_TREE_H_
