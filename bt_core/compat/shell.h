// A node of the BehaviorTree.CPP interface as the executor has it.
#ifndef COPPICE_BT_CORE_COMPAT_SHELL_H_
#define COPPICE_BT_CORE_COMPAT_SHELL_H_

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "behaviortree_cpp/tree_node.h"
#include "bt_core/compat/tree_run.h"
#include "bt_core/engine/registry.h"

namespace BT::internal {

using Declarations = std::shared_ptr<const std::vector<coppice::PortDeclaration>>;

/// The ports of a node type, all of them optional: a node says itself what it misses.
Declarations DeclarationsOf(const PortsList& ports);

/// Adds a node type whose nodes are shells: the executor makes them empty, and who makes the tree
/// fills them with Fill. Throws std::invalid_argument as Registry::Register does.
void AddShells(coppice::Registry& registry, const TreeNodeManifest& manifest);

/// The shell of a leaf without ports in the program, which takes the place of another node.
std::unique_ptr<coppice::UserNode> MakeBareShell();
coppice::Registry::TickFunction ShellTick();

void Fill(coppice::UserNode& shell, TreeNode& node, TreeRun& run);

coppice::NodeCategory CategoryOf(NodeType type);

}  // namespace BT::internal

#endif  // COPPICE_BT_CORE_COMPAT_SHELL_H_
