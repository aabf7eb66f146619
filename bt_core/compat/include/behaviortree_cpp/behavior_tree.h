// All nodes, and what can be done with a tree of them.
#pragma once

#include <cstdint>
#include <functional>
#include <iostream>
#include <utility>
#include <vector>

#include "behaviortree_cpp/action_node.h"
#include "behaviortree_cpp/actions/always_failure_node.h"
#include "behaviortree_cpp/actions/always_success_node.h"
#include "behaviortree_cpp/actions/script_condition.h"
#include "behaviortree_cpp/actions/script_node.h"
#include "behaviortree_cpp/actions/set_blackboard_node.h"
#include "behaviortree_cpp/actions/sleep_node.h"
#include "behaviortree_cpp/actions/test_node.h"
#include "behaviortree_cpp/actions/unset_blackboard_node.h"
#include "behaviortree_cpp/actions/updated_action.h"
#include "behaviortree_cpp/condition_node.h"
#include "behaviortree_cpp/controls/fallback_node.h"
#include "behaviortree_cpp/controls/if_then_else_node.h"
#include "behaviortree_cpp/controls/parallel_all_node.h"
#include "behaviortree_cpp/controls/parallel_node.h"
#include "behaviortree_cpp/controls/reactive_fallback.h"
#include "behaviortree_cpp/controls/reactive_sequence.h"
#include "behaviortree_cpp/controls/sequence_node.h"
#include "behaviortree_cpp/controls/sequence_with_memory_node.h"
#include "behaviortree_cpp/controls/switch_node.h"
#include "behaviortree_cpp/controls/try_catch_node.h"
#include "behaviortree_cpp/controls/while_do_else_node.h"
#include "behaviortree_cpp/decorators/delay_node.h"
#include "behaviortree_cpp/decorators/force_failure_node.h"
#include "behaviortree_cpp/decorators/force_success_node.h"
#include "behaviortree_cpp/decorators/inverter_node.h"
#include "behaviortree_cpp/decorators/keep_running_until_failure_node.h"
#include "behaviortree_cpp/decorators/loop_node.h"
#include "behaviortree_cpp/decorators/repeat_node.h"
#include "behaviortree_cpp/decorators/retry_node.h"
#include "behaviortree_cpp/decorators/run_once_node.h"
#include "behaviortree_cpp/decorators/script_precondition.h"
#include "behaviortree_cpp/decorators/subtree_node.h"
#include "behaviortree_cpp/decorators/timeout_node.h"
#include "behaviortree_cpp/decorators/updated_decorator.h"

namespace BT {

/// Calls the visitor with the node and all below it, in preorder.
void applyRecursiveVisitor(const TreeNode* root_node,
                           const std::function<void(const TreeNode*)>& visitor);
void applyRecursiveVisitor(TreeNode* root_node, const std::function<void(TreeNode*)>& visitor);

/// Names, each level indented.
void printTreeRecursively(const TreeNode* root_node, std::ostream& stream = std::cout);

/// UID and status of every node.
using SerializedTreeStatus = std::vector<std::pair<uint16_t, uint8_t>>;
void buildSerializedStatusSnapshot(const TreeNode* root_node,
                                   SerializedTreeStatus& serialized_buffer);

template <class T>
NodeType getType() {
  if (std::is_base_of_v<ActionNodeBase, T>) return NodeType::ACTION;
  if (std::is_base_of_v<ConditionNode, T>) return NodeType::CONDITION;
  if (std::is_base_of_v<SubTreeNode, T>) return NodeType::SUBTREE;
  if (std::is_base_of_v<DecoratorNode, T>) return NodeType::DECORATOR;
  if (std::is_base_of_v<ControlNode, T>) return NodeType::CONTROL;
  return NodeType::UNDEFINED;
}

/// The version of BehaviorTree.CPP whose interface this is.
const char* LibraryVersionString();
int LibraryVersionNumber();

}  // namespace BT
