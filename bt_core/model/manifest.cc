#include "bt_core/model/manifest.h"

namespace coppice {

const char* ToString(NodeCategory category) {
  switch (category) {
    case NodeCategory::kAction:
      return "Action";
    case NodeCategory::kCondition:
      return "Condition";
    case NodeCategory::kControl:
      return "Control";
    case NodeCategory::kDecorator:
      return "Decorator";
    case NodeCategory::kSubTree:
      return "SubTree";
  }
  return "?";
}

std::optional<NodeCategory> CategoryFromTag(std::string_view tag) {
  for (const NodeCategory category :
       {NodeCategory::kAction, NodeCategory::kCondition, NodeCategory::kControl,
        NodeCategory::kDecorator, NodeCategory::kSubTree}) {
    if (tag == ToString(category)) return category;
  }
  return std::nullopt;
}

bool IsReservedAttribute(std::string_view name) {
  return name == "name" || name == "ID" || name.substr(0, 1) == "_";
}

}  // namespace coppice
