// A plugin for BehaviorTree.CPP 4.
#include "behaviortree_cpp/bt_factory.h"

class Say : public BT::SyncActionNode {
 public:
  Say(const std::string& name, const BT::NodeConfig& config) : BT::SyncActionNode(name, config) {}
  static BT::PortsList providedPorts() { return {BT::InputPort<std::string>("text")}; }
  BT::NodeStatus tick() override {
    std::cout << "Robot says: " << getInput<std::string>("text").value() << std::endl;
    return BT::NodeStatus::SUCCESS;
  }
};

BT_REGISTER_NODES(factory) { factory.registerNodeType<Say>("Say"); }
