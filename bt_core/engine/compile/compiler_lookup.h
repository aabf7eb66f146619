// What an element of a tree is: a node type of the registry, a SubTree, or something unknown.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_LOOKUP_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_LOOKUP_H_

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/engine/compile/compiler_problems.h"
#include "bt_core/engine/compiler_site.h"
#include "bt_core/engine/registry.h"

namespace coppice {

/// What is a warning instead of an error, because a tree is checked where only the robot has
/// everything.
struct Tolerance {
  bool unknown_types = false;
  bool unknown_trees = false;
  bool types_without_class = false;  ///< Registry::AddManifest
};

struct FoundNode {
  std::string_view id;  ///< registration ID; for a SubTree the ID of its tree
  bool is_subtree = false;
  const Registry::Entry* entry = nullptr;  ///< null: unknown
};

class NodeLookup {
 public:
  NodeLookup(const Project& project, const Registry& registry, Tolerance tolerance,
             Problems& problems)
      : project_(project), registry_(registry), tolerance_(tolerance), problems_(problems) {}

  /// Reads the compact form <Drive/> and the generic one <Action ID="Drive"/>. Nothing if the
  /// element has no ID.
  std::optional<FoundNode> Find(const Site& site);

 private:
  void CheckForId(const Site& site);
  FoundNode FindType(const Site& site, std::string_view id);
  void CheckClass(const Site& site, const Registry::Entry& entry);
  void CheckUnknown(const Site& site, std::string_view id);
  void ReportUnknown(const Site& site, std::string_view id);
  void WarnOfUnknown(const Site& site, std::string_view id);
  void CheckAgainstModel(const Site& site, const NodeModel& model);
  void CheckForm(const Site& site, std::string_view id, NodeCategory category);
  std::string Advice(std::string_view id);
  const std::vector<std::string>& Types();
  const std::string& NearestType(std::string_view id);

  const Project& project_;
  const Registry& registry_;
  const Tolerance tolerance_;
  Problems& problems_;
  std::vector<std::string> types_;  // registered ones, once they are asked for
  std::map<std::string, std::string, std::less<>> nearest_;  // registered types, by unknown ones
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_LOOKUP_H_
