#include "bt_core/engine/compile/compiler_lookup.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "bt_core/engine/compile/compiler_children.h"
#include "bt_core/model/upgrade.h"

namespace coppice {
namespace {

// What belongs to a file and not into a tree.
bool IsNoNode(std::string_view tag) {
  return tag == "root" || tag == "BehaviorTree" || tag == "include" || tag == "TreeNodesModel";
}

bool DifferOnlyInCase(std::string_view a, std::string_view b) {
  const auto same = [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) ==
           std::tolower(static_cast<unsigned char>(y));
  };
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same);
}

const std::string& Same(const std::string& type) { return type; }

}  // namespace

std::optional<FoundNode> NodeLookup::Find(const Site& site) {
  const std::string_view tag = site.element.tag;
  const std::optional<NodeCategory> generic = CategoryFromTag(tag);
  if (!generic && IsNoNode(tag) && !registry_.Find(tag)) {
    problems_.Error(site.document, site.element.offset,
                    "<" + std::string(tag) + "> cannot stand inside a tree");
    return std::nullopt;
  }
  if (!generic) {
    CheckForId(site);
    return FindType(site, tag);
  }
  const std::string_view id = site.document.AttributeValue(site.element, "ID");
  if (id.empty()) {
    problems_.Error(site.document, site.element.offset, "<" + std::string(tag) + "> without ID");
    return std::nullopt;
  }
  if (*generic == NodeCategory::kSubTree) return FoundNode{id, true, registry_.Find("SubTree")};
  return FindType(site, id);
}

// <Fallback ID="Look">: the name of the node is meant, or else its type. Format 3 does not mind.
void NodeLookup::CheckForId(const Site& site) {
  const Attribute* const id = site.document.FindAttribute(site.element, "ID");
  if (!id) return;
  const std::string tag(site.element.tag);
  const bool may = project_.WasFormat3(site.document_number);
  problems_.Add(may ? Severity::kWarning : Severity::kError, site.document, id->name_offset,
                "<" + tag + "> has its type as tag, no ID",
                "name=" + Quoted(id->value) + " names the node");
}

FoundNode NodeLookup::FindType(const Site& site, std::string_view id) {
  const Registry::Entry* entry = registry_.Find(id);
  if (!entry) {
    CheckUnknown(site, id);
  } else {
    CheckForm(site, id, entry->manifest.category);
    CheckClass(site, *entry);
    const std::string wrong = WrongChildCount(id, site.element.child_count, entry->children);
    if (!wrong.empty()) problems_.Error(site.document, site.element.offset, wrong);
  }
  return {id, false, entry};
}

void NodeLookup::CheckClass(const Site& site, const Registry::Entry& entry) {
  const bool of_user = entry.type == NodeType::kLeaf || entry.type == NodeType::kUser;
  if (!of_user || entry.build || tolerance_.types_without_class) return;
  problems_.Error(site.document, site.element.offset,
                  "node type " + Quoted(entry.manifest.id) + " is known from a model only",
                  "register its class");
}

void NodeLookup::CheckUnknown(const Site& site, std::string_view id) {
  const auto model = project_.models().find(id);
  const bool is_described = model != project_.models().end();
  if (is_described) CheckAgainstModel(site, model->second);
  if (tolerance_.unknown_types) {
    if (!is_described) WarnOfUnknown(site, id);
  } else if (!registry_.fallback()) {
    ReportUnknown(site, id);
  } else if (site.element.child_count > 0) {
    problems_.Error(site.document, site.element.offset,
                    Quoted(id) + " is not built in, so it must be a leaf without children",
                    Advice(id));
  }
}

void NodeLookup::ReportUnknown(const Site& site, std::string_view id) {
  problems_.Error(site.document, site.element.offset, "unknown node type " + Quoted(id),
                  Advice(id));
}

// Once for each type. What differs from a built-in node in upper and lower case only is misspelt,
// wherever it runs.
void NodeLookup::WarnOfUnknown(const Site& site, std::string_view id) {
  const std::string& nearest = NearestType(id);
  if (DifferOnlyInCase(id, nearest) || project_.Find(id)) {
    ReportUnknown(site, id);
    return;
  }
  if (!problems_.IsFirst("node type " + std::string(id))) return;
  const std::uint32_t children = site.element.child_count;
  const Registry::Entry* near = registry_.Find(nearest);
  const bool fits = near && WrongChildCount(id, children, near->children).empty();
  problems_.Warning(
      site.document, site.element.offset,
      "node type " + Quoted(id) + " is not built in: its ports are not checked" +
          (children > 0 ? ", nor how many children it may have" : ""),
      fits ? DidYouMean(id, {nearest}) : "",
      fits ? ProblemSubject{} : ProblemSubject{ProblemKind::kNoModel, std::string(id)});
}

// A large file may use an unknown type ten thousand times.
const std::string& NodeLookup::NearestType(std::string_view id) {
  const auto known = nearest_.find(id);
  if (known != nearest_.end()) return known->second;
  return nearest_.emplace(id, problems_.Nearest(id, Types(), Same)).first->second;
}

std::string NodeLookup::Advice(std::string_view id) {
  if (project_.Find(id)) return "a tree is used as <SubTree ID=" + Quoted(id) + "/>";
  const std::string_view now = NodeNameInFormat4(id);
  if (!now.empty()) return "in format 4 it is " + std::string(now);
  return problems_.Advise(id, Types(), Same);
}

const std::vector<std::string>& NodeLookup::Types() {
  if (types_.empty()) types_ = registry_.Ids();
  return types_;
}

// A model that a file brings along may be older than the node: it is good for warnings.
void NodeLookup::CheckAgainstModel(const Site& site, const NodeModel& model) {
  CheckForm(site, model.id, model.category);
  const std::string wrong =
      WrongChildCount(model.id, site.element.child_count, ChildrenOf(model.category));
  if (!wrong.empty()) {
    problems_.Warning(site.document, site.element.offset, wrong,
                      std::string("its model says that it is a ") + ToString(model.category));
  }
  for (const Attribute& attribute : site) {
    if (IsReservedAttribute(attribute.name) || model.FindPort(attribute.name)) continue;
    const auto name_of = [](const PortModel& port) { return port.name; };
    problems_.Warning(site.document, attribute.name_offset,
                      "the model of " + model.id + " has no port " + Quoted(attribute.name),
                      problems_.Advise(attribute.name, model.ports, name_of),
                      {ProblemKind::kUnknownPort, std::string(attribute.name)});
  }
}

void NodeLookup::CheckForm(const Site& site, std::string_view id, NodeCategory category) {
  const std::string_view tag = site.element.tag;
  const char* const form = ToString(category);
  if (tag == id || tag == form) return;
  problems_.Warning(site.document, site.element.offset,
                    Quoted(id) + " is written as <" + std::string(tag) + ">",
                    std::string("it is a ") + form);
}

}  // namespace coppice
