// The trees of coppice_bench in BehaviorTree.CPP, for callgrind:
//
//   coppice_peer_bench ROUNDS < TREE.xml
#include <behaviortree_cpp/bt_factory.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>

namespace {

class RunForever : public BT::StatefulActionNode {
 public:
  using StatefulActionNode::StatefulActionNode;
  static BT::PortsList providedPorts() { return {}; }
  BT::NodeStatus onStart() override { return BT::NodeStatus::RUNNING; }
  BT::NodeStatus onRunning() override { return BT::NodeStatus::RUNNING; }
  void onHalted() override {}
};

class CondPort : public BT::ConditionNode {
 public:
  using ConditionNode::ConditionNode;
  static BT::PortsList providedPorts() {
    return {BT::InputPort<double>("value"), BT::InputPort<double>("threshold")};
  }
  BT::NodeStatus tick() override {
    const bool below = getInput<double>("value").value() < getInput<double>("threshold").value();
    return below ? BT::NodeStatus::SUCCESS : BT::NodeStatus::FAILURE;
  }
};

void Register(BT::BehaviorTreeFactory& factory) {
  const auto success = [](BT::TreeNode&) { return BT::NodeStatus::SUCCESS; };
  const auto failure = [](BT::TreeNode&) { return BT::NodeStatus::FAILURE; };
  factory.registerSimpleCondition("CondOk", success);
  factory.registerSimpleCondition("CondFail", failure);
  factory.registerSimpleAction("ActOk", success);
  factory.registerNodeType<RunForever>("RunForever");
  factory.registerNodeType<CondPort>("CondPort");
}

}  // namespace

// What callgrind counts.
extern "C" [[gnu::noinline]] void CoppicePeerTick(BT::Tree& tree) { tree.tickExactlyOnce(); }

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string text(std::istreambuf_iterator<char>(std::cin), {});
  BT::BehaviorTreeFactory factory;
  Register(factory);
  BT::Tree tree = factory.createTreeFromText(text);
  const auto board = tree.rootBlackboard();
  board->set("battery", 80.0);
  board->set("charging", false);
  board->set("counter", 0);
  tree.tickExactlyOnce();
  for (int i = std::atoi(argv[1]); i > 0; --i) CoppicePeerTick(tree);
}
