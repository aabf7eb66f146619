#include "bt_core/engine/compiler_subtrees.h"

#include <algorithm>
#include <utility>

namespace coppice {
namespace {

bool IsTrue(const Site& site, std::string_view attribute) {
  bool value = false;
  const std::string_view text = site.document.AttributeValue(site.element, attribute);
  return ValueTraits<bool>::Parse(text, value) && value;
}

}  // namespace

void SubTreeBinder::OpenMain(const std::string& id) {
  keys_.AddScope(0, false);
  program_.layout.scopes.push_back(id);
  program_.trees.push_back({id, "", 0, 0});
  const std::string_view main = program_.project->trees().find(id)->first;
  open_.push_back(main);
  is_open_.insert(main);
}

const TreeDefinition* SubTreeBinder::Find(const Site& site, std::string_view id) {
  const TreeDefinition* tree = program_.project->Find(id);
  if (!tree) {
    ReportMissing(site, id);
  } else if (is_open_.count(id) > 0) {
    ReportLoop(site, id);
    tree = nullptr;
  }
  return tree;
}

void SubTreeBinder::ReportMissing(const Site& site, std::string_view id) {
  std::vector<std::string> ids;
  for (const auto& [known, definition] : program_.project->trees()) ids.push_back(known);
  problems_.Error(site.document, site.element.offset, "no tree " + Quoted(id), DidYouMean(id, ids));
}

void SubTreeBinder::ReportLoop(const Site& site, std::string_view id) {
  std::string chain;
  for (auto at = std::find(open_.begin(), open_.end(), id); at != open_.end(); ++at) {
    chain += std::string(*at) + " -> ";
  }
  problems_.Error(site.document, site.element.offset, "tree " + Quoted(id) + " contains itself",
                  chain + std::string(id));
}

ScopeIndex SubTreeBinder::Open(const Site& site, std::string_view id, NodeIndex node) {
  if (site.element.child_count > 0) {
    problems_.Error(site.document, site.element.offset, "<SubTree> must not have children");
  }
  const ScopeIndex inner = keys_.AddScope(site.scope, IsTrue(site, "_autoremap"));
  std::string path = program_.Path(node);
  path_bytes_ += path.size();
  if (!paths_.insert(path).second) {
    problems_.Error(site.document, site.element.offset,
                    "two SubTrees in the same tree have the name " + Quoted(program_.Name(node)),
                    "give each a name of its own");
  }
  program_.layout.scopes.push_back(path);
  program_.trees.push_back({std::string(id), std::move(path), node + 1, node});
  Remap(site, inner);
  open_.push_back(id);
  is_open_.insert(id);
  return inner;
}

void SubTreeBinder::Close() {
  is_open_.erase(open_.back());
  open_.pop_back();
}

void SubTreeBinder::Remap(const Site& site, ScopeIndex inner) {
  for (const Attribute& attribute : site) {
    if (IsReservedAttribute(attribute.name)) continue;
    const std::string_view key = KeyOf(attribute.value, attribute.name);
    if (!key.empty()) {
      keys_.Bind(attribute.name, inner, keys_.Resolve(key, site.scope));
      continue;
    }
    const SlotIndex slot = keys_.AddSlot(std::string(attribute.name), inner, nullptr);
    keys_.AddLiteral(slot, attribute.value, site.document, attribute.value_offset);
    keys_.Bind(attribute.name, inner, slot);
  }
}

}  // namespace coppice
