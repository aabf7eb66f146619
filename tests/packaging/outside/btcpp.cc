// A program for BehaviorTree.CPP 4 with a plugin: its path is the argument.
#include "behaviortree_cpp/bt_factory.h"

int main(int, char** argv) {
  BT::BehaviorTreeFactory factory;
  factory.registerFromPlugin(argv[1]);
  BT::Tree tree = factory.createTreeFromText(
      "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><Say text=\"hello\"/>"
      "</BehaviorTree></root>");
  std::cout << tree.tickWhileRunning() << std::endl;
}
