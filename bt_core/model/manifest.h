// What a node type offers: the ID used in XML, its kind, its ports. Made by the runtime from the
// declaration of the node itself; the checker, the editor and the node reference read it.
#ifndef COPPICE_BT_CORE_MODEL_MANIFEST_H_
#define COPPICE_BT_CORE_MODEL_MANIFEST_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/data/port.h"

namespace coppice {

enum class NodeCategory : std::uint8_t { kAction, kCondition, kControl, kDecorator, kSubTree };

/// The XML name of a category: "Action", "Condition", "Control", "Decorator", "SubTree".
const char* ToString(NodeCategory category);

/// The category of that XML name, as in the explicit form <Action ID="..."/>.
std::optional<NodeCategory> CategoryFromTag(std::string_view tag);

struct Manifest {
  std::string id;
  NodeCategory category = NodeCategory::kAction;
  std::string description;
  std::vector<PortDeclaration> ports;
};

/// True for the attributes that are not ports: name, ID and those that begin with an underscore.
bool IsReservedAttribute(std::string_view name);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_MANIFEST_H_
