// A program for BehaviorTree.CPP 3.
#include "behaviortree_cpp_v3/bt_factory.h"

class Say : public BT::AsyncActionNode {
 public:
  Say(const std::string& name, const BT::NodeConfiguration& config)
      : BT::AsyncActionNode(name, config) {}
  static BT::PortsList providedPorts() { return {BT::InputPort<std::string>("text")}; }
  BT::NodeStatus tick() override {
    BT::Optional<std::string> text = getInput<std::string>("text");
    std::cout << "Robot says: " << text.value() << std::endl;
    return BT::NodeStatus::SUCCESS;
  }
};

int main() {
  BT::BehaviorTreeFactory factory;
  factory.registerNodeType<Say>("Say");
  BT::Tree tree = factory.createTreeFromText(
      "<root main_tree_to_execute=\"Main\"><BehaviorTree ID=\"Main\"><Say text=\"hello\"/>"
      "</BehaviorTree></root>");
  BT::NodeStatus status = BT::NodeStatus::RUNNING;
  while (status == BT::NodeStatus::RUNNING) {
    status = tree.tickRoot();
    tree.sleep(std::chrono::milliseconds(1000));
  }
  std::cout << status << std::endl;
}
