// A tree that is ready to run: flat arrays, every name resolved, every port bound to a slot.
// Immutable; any number of Executors may run the same Program.
//
// Of the documents only the texts are kept, packed: a node with its text takes about 60 bytes.
//
// Nodes lie in preorder, so the descendants of node i are the nodes i + 1 .. end of i - 1, and its
// first child is i + 1. SubTrees are expanded in place. What a tick needs is in `nodes`; what
// people need is beside it.
#ifndef COPPICE_BT_CORE_ENGINE_PROGRAM_H_
#define COPPICE_BT_CORE_ENGINE_PROGRAM_H_

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bt_core/data/blackboard.h"
#include "bt_core/engine/registry.h"
#include "bt_core/model/project.h"
#include "bt_core/model/source_text.h"
#include "bt_core/nodes/control.h"
#include "bt_core/nodes/guards.h"
#include "bt_core/script/script.h"

namespace coppice {

struct NodeRecord {
  NodeType type;
  NodeType dispatch;         ///< kGuarded if the node has guards or hooks, else its type
  NodeIndex end;             ///< one past the last descendant
  std::uint32_t first_port;  ///< of Program::ports; for a user node: its number in Program::leaves
};
static_assert(sizeof(NodeRecord) == 12);

using ScriptIndex = StrongIndex<struct ScriptTag>;  ///< of Program::scripts
inline constexpr ScriptIndex kNoScript{UINT32_MAX};

/// One port of one node, in the order of the declarations. It has neither slot nor script if it is
/// optional and not given.
struct PortBinding {
  SlotIndex slot = kNoSlot;
  ScriptIndex script = kNoScript;  ///< of a port of type ScriptCode, which has no slot
};

/// The guards and hooks of one node, in the order of Guard: numbers in Program::scripts.
struct GuardRecord {
  NodeIndex node;
  std::array<ScriptIndex, kGuardCount> scripts;  ///< kNoScript where there is none
};

/// A node of the user's C++: a leaf, or a control node or decorator of a user's class.
struct LeafRecord {
  NodeIndex node;
  std::uint32_t first_port;  ///< of Program::ports
};

/// What people want to know of a node.
struct NodeInfo {
  const Registry::Entry* entry;  ///< null for a leaf that only the fallback knows
  NodeIndex parent;              ///< itself for the root
  ScopeIndex scope;              ///< blackboard scope that its ports are looked up in
  ElementIndex element;          ///< of the document, where it is written
  std::uint32_t offset;          ///< of that element in the text, in bytes
};

/// One tree or SubTree instance, in the order of creation. Its scope has the same number.
struct TreeInstance {
  std::string id;
  std::string path;        ///< empty for the main tree
  NodeIndex root;          ///< first node inside
  NodeIndex node;          ///< the SubTree node that it hangs on; for the main tree its root
  std::uint32_t document;  ///< where it is written: a number in Program::texts
};

class Program {
 public:
  std::shared_ptr<const Registry> registry;  ///< first: values of its types end before it
  std::vector<NodeRecord> nodes;
  std::vector<PortBinding> ports;
  std::vector<LeafRecord> leaves;
  std::vector<Script> scripts;
  std::vector<GuardRecord> guards;  ///< by ascending node
  std::vector<NodeInfo> info;
  std::vector<TreeInstance> trees;
  Layout layout;
  std::vector<SourceText> texts;  ///< of the project's documents, in their order
  NodeModelMap subtree_models;    ///< Project::subtree_models()
  std::string main_tree;          ///< Project::main_tree(); another one may have been compiled

  /// Registration ID ("Sequence", "DriveTo"; for a SubTree the ID of its tree).
  std::string Id(NodeIndex node) const;
  /// Name given in the XML, or else the ID.
  std::string Name(NodeIndex node) const;
  /// "Main/patrol/DriveTo::7": path of the instance, then the name or, without one, ID::uid.
  std::string Path(NodeIndex node) const;
  /// Where it is written.
  SourceLocation Location(NodeIndex node) const;

  /// Number of its first port in `ports`, whatever kind of node it is.
  std::uint32_t FirstPort(NodeIndex node) const;

  /// How it is written. Read from the text, so it is not for what must be quick.
  StartTag TagOf(NodeIndex node) const;
  /// The text that it is written in.
  const SourceText& TextOf(NodeIndex node) const;
};

/// What "@key" names in a tree.
enum class OuterKeys : std::uint8_t {
  kOfMainTree,  ///< the key of the main tree
  kApart        ///< a slot "@key" of its own, for who has a blackboard outside of the main tree
};

/// Translates a tree of a project, which the program does not keep. All problems go to
/// `diagnostics`; returns null if one of them is an error. `tree_id` empty: the main tree of the
/// project.
std::shared_ptr<const Program> Compile(std::shared_ptr<const Project> project,
                                       std::shared_ptr<const Registry> registry,
                                       Diagnostics& diagnostics, const std::string& tree_id = {},
                                       OuterKeys outer = OuterKeys::kOfMainTree);

/// Reads and compiles a file in one go.
std::shared_ptr<const Program> CompileFile(const std::string& path,
                                           std::shared_ptr<const Registry> registry,
                                           Diagnostics& diagnostics,
                                           const std::string& tree_id = {});

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_PROGRAM_H_
