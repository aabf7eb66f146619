// The tree of a robot that knows the Groot2 protocol only, from the XML that it sends.
#ifndef COPPICE_BT_CORE_LIVE_GROOT2_CLIENT_ROBOT_TREE_H_
#define COPPICE_BT_CORE_LIVE_GROOT2_CLIENT_ROBOT_TREE_H_

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/frames/tree_description.h"

namespace coppice {

struct RobotTree {
  TreeDescription description;                         ///< without slots
  std::unordered_map<std::uint16_t, NodeIndex> nodes;  ///< by their number in the protocol
  std::vector<std::uint16_t> uids;                     ///< and back
  /// Names of the blackboards: the path of each instance; the main tree's is its ID.
  std::vector<std::string> boards;

  /// kNoNode: the robot has no such node.
  NodeIndex Find(std::uint16_t uid) const;
};

/// TreeDescription::writer of such a tree.
inline constexpr const char* kGroot2Writer = "Groot2 protocol";

/// The answer to FULLTREE. Subtrees are put where they are used. Without nodes if it makes no
/// sense; then `diagnostics` says why.
RobotTree ReadRobotTree(std::string xml, const std::string& file, Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_GROOT2_CLIENT_ROBOT_TREE_H_
