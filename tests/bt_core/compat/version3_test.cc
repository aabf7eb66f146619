// Code for BehaviorTree.CPP 3, whose headers alone say that it is.
#include <gtest/gtest.h>

#include <string>

#include "behaviortree_cpp_v3/bt_factory.h"

namespace {

class Say : public BT::SyncActionNode {
 public:
  Say(const std::string& name, const BT::NodeConfiguration& config)
      : BT::SyncActionNode(name, config) {}
  static BT::PortsList providedPorts() { return {BT::InputPort<std::string>("text")}; }
  BT::NodeStatus tick() override {
    const BT::Optional<std::string> text = getInput<std::string>("text");
    return text && text == std::string("hello") ? BT::NodeStatus::SUCCESS : BT::NodeStatus::FAILURE;
  }
};

class Slow : public BT::AsyncActionNode {
 public:
  using AsyncActionNode::AsyncActionNode;
  static BT::PortsList providedPorts() { return {}; }
  BT::NodeStatus tick() override { return BT::NodeStatus::SUCCESS; }
};

TEST(Version3, ItsNamesComeWithItsHeaders) {
  BT::BehaviorTreeFactory factory;
  factory.registerNodeType<Say>("Say");
  factory.registerNodeType<Slow>("Slow");
  factory.registerSimpleCondition("IsReady", [](BT::TreeNode& node) {
    return node.config().blackboard->get<bool>("ready") ? BT::NodeStatus::SUCCESS
                                                        : BT::NodeStatus::FAILURE;
  });
  BT::Tree tree = factory.createTreeFromText(
      "<root main_tree_to_execute=\"Main\"><BehaviorTree ID=\"Main\"><Sequence><IsReady/>"
      "<Say text=\"hello\"/><Slow/></Sequence></BehaviorTree></root>");
  tree.rootBlackboard()->set("ready", true);
  EXPECT_EQ(tree.tickRootWhileRunning(), BT::NodeStatus::SUCCESS);
}

}  // namespace
