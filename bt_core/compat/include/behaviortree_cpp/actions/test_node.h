// Stands in for a node in a test: BehaviorTreeFactory::addSubstitutionRule.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "behaviortree_cpp/action_node.h"

namespace BT {

struct TestNodeConfig {
  /// What it returns, unless one of the next two says something else.
  NodeStatus return_status = NodeStatus::SUCCESS;
  /// Run after SUCCESS, after FAILURE, and after both.
  std::string success_script;
  std::string failure_script;
  std::string post_script;
  /// RUNNING for so long.
  std::chrono::milliseconds async_delay{0};
  std::function<NodeStatus(void)> complete_func;
  /// A script whose value is the status.
  std::string return_status_script;
};

class TestNode : public StatefulActionNode {
 public:
  TestNode(const std::string& name, const NodeConfig& config,
           std::shared_ptr<TestNodeConfig> test_config);
  TestNode(const std::string& name, const NodeConfig& config, TestNodeConfig test_config)
      : TestNode(name, config, std::make_shared<TestNodeConfig>(std::move(test_config))) {}
  static PortsList providedPorts() { return {}; }

 protected:
  NodeStatus onStart() override;
  NodeStatus onRunning() override;
  void onHalted() override {}

 private:
  NodeStatus Complete();
  NodeStatus ResultNow(Ast::Environment& environment) const;

  std::shared_ptr<TestNodeConfig> test_config_;
  std::chrono::steady_clock::time_point end_;
};

}  // namespace BT
