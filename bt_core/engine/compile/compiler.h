// Document -> Program: the walk over the elements of a tree and of the SubTrees in it.
//
// The walk builds the flat arrays in preorder; what is behind a name is left to the other parts:
// compiler_lookup (node types), compiler_ports, compiler_subtrees, compiler_guards and
// compiler_scripts. It keeps its own stack, so the depth of a tree costs no stack of the thread. No
// part stops at a problem, so one run finds all of them.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bt_core/engine/compile/compiler_guards.h"
#include "bt_core/engine/compile/compiler_lookup.h"
#include "bt_core/engine/compile/compiler_ports.h"
#include "bt_core/engine/compile/compiler_problems.h"
#include "bt_core/engine/compile/compiler_scripts.h"
#include "bt_core/engine/compile/compiler_subtrees.h"
#include "bt_core/engine/compile/compiler_types.h"
#include "bt_core/engine/compile/keys.h"
#include "bt_core/engine/compiler_site.h"
#include "bt_core/engine/program.h"

namespace coppice {

class TreeCompiler {
 public:
  /// `texts`: Program::texts of the project if another compiler has packed them already.
  TreeCompiler(std::shared_ptr<const Project> project, std::shared_ptr<const Registry> registry,
               Tolerance tolerance, Problems& problems, std::vector<SourceText> texts = {});

  /// Translates one tree, once. The result is good for a run only if no errors were reported.
  std::shared_ptr<Program> Run(const std::string& tree_id, const TreeDefinition& tree,
                               OuterKeys outer = OuterKeys::kOfMainTree);

 private:
  // A node whose children are being added.
  struct Level {
    NodeIndex node;
    std::uint32_t document;
    ElementIndex next;  // child to add
    ScopeIndex scope;   // of the children
    bool is_subtree;
  };

  void Walk(const Site& root);
  void AddChild();
  void EndLevel();
  void AddElement(const Site& site, NodeIndex parent);
  void AddNode(const Site& site, const FoundNode& found, NodeIndex parent);
  void AddSubTree(const Site& site, const FoundNode& found, NodeIndex parent);
  void CheckGuardsOfNoNode(const Site& site);
  NodeIndex AddRecord(NodeType type, const Site& site, const Registry::Entry* entry,
                      NodeIndex parent);
  void AddLeaf(NodeIndex node);
  void CountPath(const Site& site);
  bool IsTooBig(const Site& site);
  void GiveBackSpareMemory();

  const std::shared_ptr<const Project> project_;
  std::shared_ptr<Program> program_;
  Problems& problems_;
  KeyTable keys_;
  SlotTypes types_;
  ScriptTable scripts_;
  PortBinder ports_;
  GuardReader guards_;
  NodeLookup lookup_;
  SubTreeBinder subtrees_;
  std::vector<Level> levels_;
  std::size_t long_path_bytes_ = 0;  // of nodes and ports, each with the whole path
  bool too_big_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_H_
