// Makes a Tree of a Program: blackboards, nodes, and what joins them to the executor.
#ifndef COPPICE_BT_CORE_COMPAT_TREE_MAKER_H_
#define COPPICE_BT_CORE_COMPAT_TREE_MAKER_H_

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "behaviortree_cpp/bt_factory.h"
#include "bt_core/compat/tree_run.h"

namespace BT::internal {

/// What a factory knows that a tree is made with.
struct Making {
  const BehaviorTreeFactory& factory;
  std::shared_ptr<ScriptingEnumsRegistry> enums;
  /// The rule that a node of that name, ID and path falls under, or null.
  std::function<const BehaviorTreeFactory::SubstitutionRule*(
      const std::string& name, const std::string& id, const std::string& path)>
      rule;
};

class TreeMaker {
 public:
  TreeMaker(const Making& making, std::shared_ptr<const coppice::Program> program,
            Blackboard::Ptr main_board);

  /// The parts of a Tree; `manifests` must outlive the nodes.
  std::unique_ptr<TreeRun> Make(std::vector<Tree::Subtree::Ptr>& subtrees,
                                const std::unordered_map<std::string, TreeNodeManifest>& manifests);

 private:
  void Substitute();
  void MakeBoards(std::vector<Tree::Subtree::Ptr>& subtrees, Blackboard::Ptr main_board);
  void AttachKeys();
  void AddNode(coppice::NodeIndex node,
               const std::unordered_map<std::string, TreeNodeManifest>& manifests);
  NodeConfig ConfigOf(coppice::NodeIndex node, const TreeNodeManifest* manifest) const;
  std::vector<PortLink> LinksOf(coppice::NodeIndex node, const TreeNodeManifest* manifest);
  void Declare(coppice::NodeIndex node, const TreeNodeManifest* manifest, const NodeConfig& given);
  void DeclarePort(const PortInfo& port, Cell& cell, const std::string& key);
  void ReadLiteral(coppice::NodeIndex node, const std::string& name, const PortInfo& port,
                   coppice::Slot& slot);
  void ReadEnum(const PortInfo& port, const std::string& text, coppice::Slot& slot) const;
  TreeNode::Ptr MakeNode(coppice::NodeIndex node, const NodeConfig& config);
  void JoinToParent(coppice::NodeIndex node, TreeNode& made);

  const Making& making_;
  std::shared_ptr<const coppice::Program> program_;
  Blackboard::Ptr main_board_;
  std::unique_ptr<TreeRun> run_;
  std::vector<Blackboard::Ptr> boards_;                              // by scope
  std::vector<std::shared_ptr<Cell>> cells_;                         // by slot; null: of no key
  std::vector<const BehaviorTreeFactory::SubstitutionRule*> rules_;  // by node
};

}  // namespace BT::internal

#endif  // COPPICE_BT_CORE_COMPAT_TREE_MAKER_H_
