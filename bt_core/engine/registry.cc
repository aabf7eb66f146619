#include "bt_core/engine/registry.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace coppice {

Registry::Registry() {
  for (const BuiltIn& node : BuiltIns()) {
    Entry entry{node.type, node.children, node.manifest, nullptr, nullptr, node.manifest.ports};
    const auto is_private = [](const PortDeclaration& port) {
      return port.direction == PortDirection::kMailbox;
    };
    std::vector<PortDeclaration>& visible = entry.manifest.ports;
    visible.erase(std::remove_if(visible.begin(), visible.end(), is_private), visible.end());
    entries_[node.manifest.id] = std::move(entry);
  }
}

Status Registry::TickVirtually(UserNode& node, Status before) {
  bool starting = before != Status::kRunning;
  if (starting && node.host().keeps_skipped_nodes()) starting = !node.host().ResumeSkipped();
  const Status result = node.Tick(starting);
  if (result == Status::kIdle) throw std::logic_error("returned IDLE, which no node may");
  if (result == Status::kSkipped) node.host().KeepSkipped();
  return result;
}

const Registry::Entry* Registry::Find(std::string_view id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : &found->second;
}

bool Registry::HasBuiltIn(std::string_view id) const {
  const Entry* entry = Find(id);
  return entry && entry->type != NodeType::kLeaf && entry->type != NodeType::kUser;
}

std::vector<std::string> Registry::Ids() const {
  std::vector<std::string> ids;
  for (const auto& [id, entry] : entries_) ids.push_back(id);
  return ids;
}

void Registry::AddManifest(Manifest manifest, ChildCount children,
                           std::shared_ptr<const void> types) {
  Entry entry;
  entry.type = children.max == 0 ? NodeType::kLeaf : NodeType::kUser;
  entry.children = children;
  entry.declarations = manifest.ports;
  entry.types = std::move(types);
  const std::string id = manifest.id;
  entry.manifest = std::move(manifest);
  entries_.emplace(id, std::move(entry));
}

void Registry::AddBuilder(Manifest manifest, ChildCount children, Builder build,
                          TickFunction tick) {
  Entry entry;
  entry.type = children.max == 0 ? NodeType::kLeaf : NodeType::kUser;
  entry.children = children;
  entry.manifest = std::move(manifest);
  entry.manifest.ports.clear();
  entry.build = std::move(build);
  entry.tick = tick;
  Add(std::move(entry));
}

void Registry::AddAlias(const std::string& id, const std::string& known) {
  const Entry* const entry = Find(known);
  if (!entry) throw std::invalid_argument("no node type \"" + known + "\"");
  if (Find(id)) throw std::invalid_argument("node ID \"" + id + "\" is already registered");
  Entry alias = *entry;
  alias.manifest.id = id;
  entries_.emplace(id, std::move(alias));
}

void Registry::Add(Entry entry) {
  const std::string id = entry.manifest.id;
  if (id.empty() || !std::isalpha(static_cast<unsigned char>(id.front()))) {
    throw std::invalid_argument("node ID \"" + id + "\" must begin with a letter");
  }
  if (entries_.count(id))
    throw std::invalid_argument("node ID \"" + id + "\" is already registered");
  const PortCollector collector;
  const std::unique_ptr<UserNode> prototype = entry.build();
  for (const PortCollector::Port& port : collector.ports) {
    entry.declarations.push_back(port.declaration);
    if (port.declaration.direction == PortDirection::kMailbox) continue;
    if (IsReservedAttribute(port.declaration.name)) {
      throw std::invalid_argument("port \"" + port.declaration.name + "\" of " + id +
                                  " has a reserved name");
    }
    if (port.declaration.type == &TypeOf<ScriptCode>()) {
      throw std::invalid_argument("port \"" + port.declaration.name + "\" of " + id +
                                  " is a script, which only built-in nodes may have");
    }
    entry.manifest.ports.push_back(port.declaration);
  }
  for (const PortDeclaration& port : entry.manifest.ports) {
    if (port.type && port.type->enumerators) AddEnumerators(*port.type->enumerators);
  }
  entries_[id] = std::move(entry);
}

void Registry::AddScriptConstant(const std::string& name, std::int64_t value) {
  const auto [at, inserted] = script_constants_.emplace(name, value);
  if (inserted || at->second == value) return;
  throw std::invalid_argument("script constant \"" + name + "\" is " + std::to_string(at->second) +
                              ", not " + std::to_string(value));
}

void Registry::AddEnumerators(const EnumeratorList& list) {
  for (const Enumerator& enumerator : list) {
    const std::string name(enumerator.name);
    if (ambiguous_constants_.count(name) > 0) continue;
    const auto [at, inserted] = script_constants_.emplace(name, enumerator.value);
    if (inserted || at->second == enumerator.value) continue;
    script_constants_.erase(at);
    ambiguous_constants_.insert(name);
  }
}

}  // namespace coppice
