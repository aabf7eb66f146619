// Ports that say what a node returns: SUCCESS, FAILURE, RUNNING or SKIPPED.
#ifndef COPPICE_BT_CORE_NODES_RESULT_PORT_H_
#define COPPICE_BT_CORE_NODES_RESULT_PORT_H_

#include <cstdint>
#include <stdexcept>

#include "bt_core/data/standard_types.h"
#include "bt_core/nodes/control.h"

namespace coppice::internal {

/// The value of the k-th port. Throws std::invalid_argument for IDLE, which is not a result.
template <class Tree>
Status ResultPort(const Tree& tree, NodeIndex node, std::uint32_t k) {
  const Status result = tree.template Port<Status>(node, k);
  if (result == Status::kIdle) throw std::invalid_argument("IDLE is not a result");
  return result;
}

}  // namespace coppice::internal

#endif  // COPPICE_BT_CORE_NODES_RESULT_PORT_H_
