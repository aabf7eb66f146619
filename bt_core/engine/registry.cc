#include "bt_core/engine/registry.h"

#include <cctype>
#include <stdexcept>

namespace coppice {

Registry::Registry() {
  for (const BuiltIn& node : BuiltIns()) {
    entries_[node.manifest.id] =
        Entry{node.type, node.children, node.manifest, nullptr, node.manifest.ports};
  }
}

const Registry::Entry* Registry::Find(std::string_view id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : &found->second;
}

std::vector<std::string> Registry::Ids() const {
  std::vector<std::string> ids;
  for (const auto& [id, entry] : entries_) ids.push_back(id);
  return ids;
}

void Registry::Add(const std::string& id, NodeCategory category, std::string description,
                   Builder build) {
  if (id.empty() || !std::isalpha(static_cast<unsigned char>(id.front()))) {
    throw std::invalid_argument("node ID \"" + id + "\" must begin with a letter");
  }
  if (entries_.count(id))
    throw std::invalid_argument("node ID \"" + id + "\" is already registered");
  Manifest manifest{id, category, std::move(description), {}};
  const PortCollector collector;
  const std::unique_ptr<Leaf> prototype = build();
  std::vector<PortDeclaration> declarations;
  for (const PortCollector::Port& port : collector.ports) {
    declarations.push_back(port.declaration);
    if (port.declaration.direction == PortDirection::kMailbox) continue;
    if (IsReservedAttribute(port.declaration.name)) {
      throw std::invalid_argument("port \"" + port.declaration.name + "\" of " + id +
                                  " has a reserved name");
    }
    manifest.ports.push_back(port.declaration);
  }
  entries_[id] = Entry{
      NodeType::kLeaf, {0, 0}, std::move(manifest), std::move(build), std::move(declarations)};
}

}  // namespace coppice
