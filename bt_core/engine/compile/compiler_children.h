// How many children a node has and may have.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_CHILDREN_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_CHILDREN_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "bt_core/nodes/node_type.h"

namespace coppice {

/// "Inverter has 2 children, expected exactly 1"; empty if the number is right.
std::string WrongChildCount(std::string_view id, std::uint32_t count, ChildCount allowed);

/// What is known of a node of which only the category is known.
ChildCount ChildrenOf(NodeCategory category);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_CHILDREN_H_
