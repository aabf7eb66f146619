// SubTrees: an element becomes an instance of another tree, with a scope of its own whose keys the
// attributes of the element tie to keys outside or to literals.
//
// A <SubTree> in <TreeNodesModel> declares the ports of a tree, as in BehaviorTree.CPP: one without
// default must be given, unless the SubTree has _autoremap.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_SUBTREES_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_SUBTREES_H_

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "bt_core/engine/compile/compiler_lookup.h"
#include "bt_core/engine/compile/compiler_problems.h"
#include "bt_core/engine/compile/compiler_types.h"
#include "bt_core/engine/compile/keys.h"
#include "bt_core/engine/compiler_site.h"
#include "bt_core/engine/program.h"

namespace coppice {

class SubTreeBinder {
 public:
  SubTreeBinder(const Project& project, Program& program, KeyTable& keys, SlotTypes& types,
                Tolerance tolerance, Problems& problems)
      : project_(project),
        program_(program),
        keys_(keys),
        types_(types),
        tolerance_(tolerance),
        problems_(problems) {}

  /// The main tree: scope 0.
  void OpenMain(const std::string& id, const TreeDefinition& tree);

  /// The tree that a SubTree names. Null, with an error, if there is none or if it is one of those
  /// that are open now.
  const TreeDefinition* Find(const Site& site, std::string_view id);

  /// Makes the instance that hangs on that SubTree node, which must be in the program already, and
  /// returns its scope. What is added until Close is inside.
  ScopeIndex Open(const Site& site, std::string_view id, const TreeDefinition& tree,
                  NodeIndex node);
  void Close();

  /// Length of the paths of all instances so far, in bytes.
  std::size_t path_bytes() const { return path_bytes_; }

 private:
  void ReportMissing(const Site& site, std::string_view id);
  void ReportLoop(const Site& site, std::string_view id);
  ScopeIndex AddInstance(const Site& site, TreeInstance instance, bool autoremap);
  void Remap(const Site& site, ScopeIndex inner);
  void RemapOne(const Site& site, ScopeIndex inner, std::string_view name, std::string_view text,
                std::uint32_t offset);
  void ApplyModel(const Site& site, const NodeModel& model, ScopeIndex inner, bool autoremap);
  void ReportMissingPort(const Site& site, const NodeModel& model, const PortModel& port);
  void CheckNames(const Site& site, const NodeModel& model);

  const Project& project_;
  Program& program_;
  KeyTable& keys_;
  SlotTypes& types_;
  const Tolerance tolerance_;
  Problems& problems_;
  std::vector<std::string_view> open_;
  std::unordered_set<std::string_view> is_open_;
  std::unordered_set<std::string> paths_;
  std::size_t path_bytes_ = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_SUBTREES_H_
