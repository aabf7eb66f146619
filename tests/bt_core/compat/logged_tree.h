// A tree for the tests of loggers: an action that takes two ticks, and an answer that fails.
#ifndef COPPICE_TESTS_BT_CORE_COMPAT_LOGGED_TREE_H_
#define COPPICE_TESTS_BT_CORE_COMPAT_LOGGED_TREE_H_

#include "behaviortree_cpp/bt_factory.h"

namespace compat_test {

class TwoTicks : public BT::StatefulActionNode {
 public:
  using StatefulActionNode::StatefulActionNode;
  static BT::PortsList providedPorts() { return {BT::OutputPort<double>("speed")}; }
  BT::NodeStatus onStart() override {
    setOutput("speed", 0.5);
    return BT::NodeStatus::RUNNING;
  }
  BT::NodeStatus onRunning() override { return BT::NodeStatus::SUCCESS; }
  void onHalted() override {}
};

/// Nodes 1 (Main's Fallback) to 4: Inverter, TwoTicks, SubTree; and 5 in the SubTree.
struct LoggedTree {
  LoggedTree() {
    factory.registerNodeType<TwoTicks>("TwoTicks");
    factory.registerBehaviorTreeFromText(R"(
      <root BTCPP_format="4">
        <BehaviorTree ID="Main">
          <Fallback>
            <Inverter><TwoTicks name="go" speed="{speed}"/></Inverter>
            <SubTree ID="Inner" name="inner"/>
          </Fallback>
        </BehaviorTree>
        <BehaviorTree ID="Inner"><AlwaysSuccess name="yes"/></BehaviorTree>
      </root>)");
    tree = factory.createTree("Main");
  }
  BT::BehaviorTreeFactory factory;
  BT::Tree tree;
};

}  // namespace compat_test

#endif  // COPPICE_TESTS_BT_CORE_COMPAT_LOGGED_TREE_H_
