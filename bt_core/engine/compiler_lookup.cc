#include "bt_core/engine/compiler_lookup.h"

#include <string>

namespace coppice {

std::optional<FoundNode> NodeLookup::Find(const Site& site) {
  const std::string_view tag = site.element.tag;
  const std::optional<NodeCategory> generic = CategoryFromTag(tag);
  if (!generic) return FindType(site, tag);
  const std::string_view id = site.document.AttributeValue(site.element, "ID");
  if (id.empty()) {
    problems_.Error(site.document, site.element.offset, "<" + std::string(tag) + "> without ID");
    return std::nullopt;
  }
  if (*generic == NodeCategory::kSubTree) return FoundNode{id, true, registry_.Find("SubTree")};
  return FindType(site, id);
}

FoundNode NodeLookup::FindType(const Site& site, std::string_view id) {
  const Registry::Entry* entry = registry_.Find(id);
  if (entry) {
    CheckForm(site, *entry);
  } else if (!registry_.fallback()) {
    ReportUnknown(site, id);
  } else if (site.element.child_count > 0) {
    problems_.Error(site.document, site.element.offset,
                    Quoted(id) + " is not built in, so it must be a leaf without children",
                    DidYouMean(id, registry_.Ids()));
  }
  return {id, false, entry};
}

void NodeLookup::ReportUnknown(const Site& site, std::string_view id) {
  const bool is_tree = project_.Find(id) != nullptr;
  problems_.Error(site.document, site.element.offset, "unknown node type " + Quoted(id),
                  is_tree ? "a tree is used as <SubTree ID=" + Quoted(id) + "/>"
                          : DidYouMean(id, registry_.Ids()));
}

void NodeLookup::CheckForm(const Site& site, const Registry::Entry& entry) {
  const std::string_view tag = site.element.tag;
  const std::string category = ToString(entry.manifest.category);
  if (tag == entry.manifest.id || tag == category) return;
  problems_.Warning(site.document, site.element.offset,
                    Quoted(entry.manifest.id) + " is written as <" + std::string(tag) + ">",
                    "it is a " + category);
}

}  // namespace coppice
