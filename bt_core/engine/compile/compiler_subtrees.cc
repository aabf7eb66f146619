#include "bt_core/engine/compile/compiler_subtrees.h"

#include <algorithm>
#include <utility>

#include "bt_core/engine/compile/sibling_files.h"
#include "bt_core/engine/compile/type_names.h"
#include "bt_core/model/keys.h"

namespace coppice {

void SubTreeBinder::OpenMain(const std::string& id, const TreeDefinition& tree) {
  keys_.AddScope(kMainScope, false);
  program_.layout.scopes.push_back(id);
  program_.trees.push_back({id, "", kRootNode, kRootNode, tree.document});
  const std::string_view main = project_.trees().find(id)->first;
  open_.push_back(main);
  is_open_.insert(main);
}

const TreeDefinition* SubTreeBinder::Find(const Site& site, std::string_view id) {
  const TreeDefinition* tree = project_.Find(id);
  if (!tree) {
    ReportMissing(site, id);
  } else if (is_open_.count(id) > 0) {
    ReportLoop(site, id);
    tree = nullptr;
  }
  return tree;
}

void SubTreeBinder::ReportMissing(const Site& site, std::string_view id) {
  const std::string file = problems_.siblings().FindTree(site.document.file(), id);
  const auto id_of = [](const auto& tree) { return tree.first; };
  const std::string advice = file.empty() ? problems_.Advise(id, project_.trees(), id_of)
                                          : file + " has it; include that file";
  if (!tolerance_.unknown_trees) {
    problems_.Error(site.document, site.element.offset, "no tree " + Quoted(id), advice);
  } else {
    problems_.Warning(site.document, site.element.offset,
                      "tree " + Quoted(id) + " is not among these files", advice);
  }
}

void SubTreeBinder::ReportLoop(const Site& site, std::string_view id) {
  std::string chain;
  for (auto at = std::find(open_.begin(), open_.end(), id); at != open_.end(); ++at) {
    chain += std::string(*at) + " -> ";
  }
  problems_.Error(site.document, site.element.offset, "tree " + Quoted(id) + " contains itself",
                  chain + std::string(id));
}

ScopeIndex SubTreeBinder::Open(const Site& site, std::string_view id, const TreeDefinition& tree,
                               NodeIndex node) {
  if (site.element.child_count > 0) {
    problems_.Error(site.document, site.element.offset, "<SubTree> must not have children");
  }
  const bool autoremap = IsAutoremapped(site.document, site.element);
  const ScopeIndex inner = AddInstance(
      site, {std::string(id), program_.Path(node), node + 1, node, tree.document}, autoremap);
  Remap(site, inner);
  if (const NodeModel* model = project_.SubTreeModel(id)) {
    ApplyModel(site, *model, inner, autoremap);
    CheckNames(site, *model);
  }
  open_.push_back(id);
  is_open_.insert(id);
  return inner;
}

ScopeIndex SubTreeBinder::AddInstance(const Site& site, TreeInstance instance, bool autoremap) {
  path_bytes_ += instance.path.size();
  if (!paths_.insert(instance.path).second) {
    problems_.Error(
        site.document, site.element.offset,
        "two SubTrees in the same tree have the name " + Quoted(program_.Name(instance.node)),
        "give each a name of its own");
  }
  program_.layout.scopes.push_back(instance.path);
  program_.trees.push_back(std::move(instance));
  return keys_.AddScope(site.scope, autoremap);
}

void SubTreeBinder::Close() {
  is_open_.erase(open_.back());
  open_.pop_back();
}

void SubTreeBinder::Remap(const Site& site, ScopeIndex inner) {
  for (const Attribute& attribute : site) {
    if (IsReservedAttribute(attribute.name)) continue;
    RemapOne(site, inner, attribute.name, attribute.value, attribute.value_offset);
  }
}

void SubTreeBinder::RemapOne(const Site& site, ScopeIndex inner, std::string_view name,
                             std::string_view text, std::uint32_t offset) {
  const std::string_view key = KeyOf(text, name);
  if (!key.empty()) {
    keys_.Bind(name, inner, keys_.Resolve(key, site.scope));
    return;
  }
  const SlotIndex slot = keys_.AddSlot(std::string(name), inner, nullptr);
  keys_.Bind(name, inner, slot);
  types_.AddLiteral(slot, text, "key " + Quoted(name) + " inside", {&site.document, offset});
}

void SubTreeBinder::ApplyModel(const Site& site, const NodeModel& model, ScopeIndex inner,
                               bool autoremap) {
  const Document& document = project_.documents()[model.document];
  const std::uint32_t offset = document.element(model.element).offset;
  for (const PortModel& port : model.ports) {
    const bool given = site.document.FindAttribute(site.element, port.name) != nullptr;
    if (!given && !autoremap && port.default_text) {
      RemapOne(site, inner, port.name, *port.default_text, site.element.offset);
    } else if (!given && !autoremap) {
      ReportMissingPort(site, model, port);
    }
    const Type* type = FindType(*program_.registry, port.type);
    if (type) types_.Suggest(keys_.Resolve(port.name, inner), *type, {&document, offset});
  }
}

// Format 3 does not look at the models of SubTrees.
void SubTreeBinder::ReportMissingPort(const Site& site, const NodeModel& model,
                                      const PortModel& port) {
  const bool may = project_.WasFormat3(site.document_number);
  problems_.Add(may ? Severity::kWarning : Severity::kError, site.document, site.element.offset,
                "SubTree " + Quoted(model.id) + " needs its port " + Quoted(port.name) +
                    (may ? " in format 4" : ""),
                port.description, {ProblemKind::kMissingPort, port.name});
}

void SubTreeBinder::CheckNames(const Site& site, const NodeModel& model) {
  for (const Attribute& attribute : site) {
    if (IsReservedAttribute(attribute.name) || model.FindPort(attribute.name)) continue;
    const auto name_of = [](const PortModel& port) { return port.name; };
    problems_.Warning(
        site.document, attribute.name_offset,
        "the model of SubTree " + Quoted(model.id) + " has no port " + Quoted(attribute.name),
        problems_.Advise(attribute.name, model.ports, name_of),
        {ProblemKind::kUnknownPort, std::string(attribute.name)});
  }
}

}  // namespace coppice
