#include "bt_core/engine/program.h"

namespace coppice {

const Document& Program::DocumentOf(NodeIndex node) const {
  return project->documents()[info[node].document];
}

const Element& Program::ElementOf(NodeIndex node) const {
  return DocumentOf(node).element(info[node].element);
}

std::string Program::Id(NodeIndex node) const {
  const Element& element = ElementOf(node);
  if (CategoryFromTag(element.tag)) {
    return std::string(DocumentOf(node).AttributeValue(element, "ID"));
  }
  return std::string(element.tag);
}

std::string Program::Name(NodeIndex node) const {
  const std::string_view name = DocumentOf(node).AttributeValue(ElementOf(node), "name");
  return name.empty() ? Id(node) : std::string(name);
}

std::string Program::Path(NodeIndex node) const {
  const std::string& instance = trees[info[node].scope].path;
  const std::string_view name = DocumentOf(node).AttributeValue(ElementOf(node), "name");
  const std::string own =
      name.empty() ? Id(node) + "::" + std::to_string(node + 1) : std::string(name);
  return instance.empty() ? own : instance + "/" + own;
}

SourceLocation Program::Location(NodeIndex node) const {
  return DocumentOf(node).Location(ElementOf(node).offset);
}

std::uint32_t Program::FirstPort(NodeIndex node) const {
  const NodeRecord& record = nodes[node];
  const bool of_user = record.type == NodeType::kLeaf || record.type == NodeType::kUser;
  return of_user ? leaves[record.first_port].first_port : record.first_port;
}

}  // namespace coppice
