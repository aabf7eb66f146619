// What an element of a tree is: a node type of the registry, a SubTree, or something unknown.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILER_LOOKUP_H_
#define COPPICE_BT_CORE_ENGINE_COMPILER_LOOKUP_H_

#include <optional>
#include <string_view>

#include "bt_core/engine/compiler_problems.h"
#include "bt_core/engine/compiler_site.h"
#include "bt_core/engine/registry.h"

namespace coppice {

struct FoundNode {
  std::string_view id;  ///< registration ID; for a SubTree the ID of its tree
  bool is_subtree = false;
  const Registry::Entry* entry = nullptr;  ///< null: unknown, taken for a leaf
};

class NodeLookup {
 public:
  NodeLookup(const Project& project, const Registry& registry, Problems& problems)
      : project_(project), registry_(registry), problems_(problems) {}

  /// Reads the compact form <Drive/> and the generic one <Action ID="Drive"/>. Nothing if the
  /// element has no ID. An ID that neither the registry nor its fallback knows is an error.
  std::optional<FoundNode> Find(const Site& site);

 private:
  FoundNode FindType(const Site& site, std::string_view id);
  void ReportUnknown(const Site& site, std::string_view id);
  void CheckForm(const Site& site, const Registry::Entry& entry);

  const Project& project_;
  const Registry& registry_;
  Problems& problems_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILER_LOOKUP_H_
