// Nodes of users, written as the documentation of BehaviorTree.CPP says.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "behaviortree_cpp/bt_factory.h"

namespace {

using BT::NodeStatus;

std::string Main(const std::string& body) {
  return "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">" + body + "</BehaviorTree></root>";
}

// What the nodes of a test have done, in their order.
std::vector<std::string>& Events() {
  static std::vector<std::string> events;
  return events;
}
std::vector<std::string> TakeEvents() { return std::exchange(Events(), {}); }

class Walk : public BT::StatefulActionNode {
 public:
  using StatefulActionNode::StatefulActionNode;
  static BT::PortsList providedPorts() { return {BT::InputPort<int>("steps", 2, "how many")}; }
  NodeStatus onStart() override {
    Events().push_back("start " + name());
    left_ = getInput<int>("steps").value();
    return NodeStatus::RUNNING;
  }
  NodeStatus onRunning() override {
    Events().push_back("go on " + name());
    return --left_ > 0 ? NodeStatus::RUNNING : NodeStatus::SUCCESS;
  }
  void onHalted() override { Events().push_back("halt " + name()); }

 private:
  int left_ = 0;
};

// A control node as users write them: the children in turn, one in each activation.
class InTurn : public BT::ControlNode {
 public:
  using ControlNode::ControlNode;
  static BT::PortsList providedPorts() { return {}; }
  NodeStatus tick() override {
    if (status() == NodeStatus::IDLE) next_ = (next_ + 1) % childrenCount();
    setStatus(NodeStatus::RUNNING);
    const NodeStatus result = children_nodes_[next_]->executeTick();
    if (BT::isStatusCompleted(result)) resetChildren();
    return result;
  }

 private:
  std::size_t next_ = 1;
};

class Twice : public BT::DecoratorNode {
 public:
  using DecoratorNode::DecoratorNode;
  static BT::PortsList providedPorts() { return {}; }
  NodeStatus tick() override {
    setStatus(NodeStatus::RUNNING);
    for (; done_ < 2; ++done_) {
      if (child_node_->executeTick() == NodeStatus::RUNNING) return NodeStatus::RUNNING;
      resetChild();
    }
    done_ = 0;
    return NodeStatus::SUCCESS;
  }

 private:
  int done_ = 0;
};

class Counting : public BT::CoroActionNode {
 public:
  using CoroActionNode::CoroActionNode;
  static BT::PortsList providedPorts() { return {}; }
  NodeStatus tick() override {
    struct Last {
      ~Last() { Events().push_back("end of the scope"); }
    } last;
    for (const char* number : {"one", "two"}) {
      Events().push_back(number);
      setStatusRunningAndYield();
    }
    return NodeStatus::SUCCESS;
  }
};

class Thinking : public BT::ThreadedAction {
 public:
  using ThreadedAction::ThreadedAction;
  static BT::PortsList providedPorts() {
    return {BT::InputPort<int>("question"), BT::OutputPort<int>("answer")};
  }
  NodeStatus tick() override {
    setOutput("answer", 2 * getInput<int>("question").value());
    return NodeStatus::SUCCESS;
  }
};

class UntilHalted : public BT::ThreadedAction {
 public:
  using ThreadedAction::ThreadedAction;
  static BT::PortsList providedPorts() { return {BT::OutputPort<int>("answer")}; }
  NodeStatus tick() override {
    while (!isHaltRequested()) std::this_thread::yield();
    setOutput("answer", 1);
    return NodeStatus::SUCCESS;
  }
};

struct Nodes : testing::Test {
  Nodes() {
    TakeEvents();
    factory.registerNodeType<Walk>("Walk");
    factory.registerNodeType<InTurn>("InTurn");
    factory.registerNodeType<Twice>("Twice");
    factory.registerNodeType<Counting>("Counting");
    factory.registerNodeType<Thinking>("Thinking");
    factory.registerNodeType<UntilHalted>("UntilHalted");
  }
  BT::BehaviorTreeFactory factory;
};

TEST_F(Nodes, AStatefulActionStartsAndGoesOn) {
  BT::Tree tree = factory.createTreeFromText(Main("<Walk name=\"w\"/>"));
  EXPECT_EQ(tree.tickExactlyOnce(), NodeStatus::RUNNING);
  EXPECT_EQ(tree.tickExactlyOnce(), NodeStatus::RUNNING);
  EXPECT_EQ(tree.tickExactlyOnce(), NodeStatus::SUCCESS);
  EXPECT_EQ(TakeEvents(), (std::vector<std::string>{"start w", "go on w", "go on w"}));
}

TEST_F(Nodes, AStatefulActionIsToldThatItIsHalted) {
  BT::Tree tree = factory.createTreeFromText(Main("<Walk name=\"w\"/>"));
  tree.tickExactlyOnce();
  tree.haltTree();
  EXPECT_EQ(TakeEvents(), (std::vector<std::string>{"start w", "halt w"}));
  EXPECT_EQ(tree.rootNode()->status(), NodeStatus::IDLE);
}

TEST_F(Nodes, AControlNodeOfTheUserTicksItsChildren) {
  BT::Tree tree =
      factory.createTreeFromText(Main("<InTurn><Walk name=\"a\" steps=\"1\"/>"
                                      "<Walk name=\"b\" steps=\"1\"/></InTurn>"));
  tree.tickWhileRunning(std::chrono::milliseconds(0));
  tree.tickWhileRunning(std::chrono::milliseconds(0));
  EXPECT_EQ(TakeEvents(), (std::vector<std::string>{"start a", "go on a", "start b", "go on b"}));
}

TEST_F(Nodes, AHaltReachesTheChildrenOfAControlNodeOfTheUser) {
  BT::Tree tree = factory.createTreeFromText(Main("<InTurn><Walk name=\"a\"/></InTurn>"));
  tree.tickExactlyOnce();
  tree.haltTree();
  EXPECT_EQ(TakeEvents(), (std::vector<std::string>{"start a", "halt a"}));
}

TEST_F(Nodes, ADecoratorOfTheUserTicksItsChild) {
  BT::Tree tree = factory.createTreeFromText(Main("<Twice><AlwaysFailure/></Twice>"));
  EXPECT_EQ(tree.tickOnce(), NodeStatus::SUCCESS);
}

TEST_F(Nodes, ACoroutineGoesOnBehindItsYield) {
  BT::Tree tree = factory.createTreeFromText(Main("<Counting/>"));
  EXPECT_EQ(tree.tickExactlyOnce(), NodeStatus::RUNNING);
  EXPECT_EQ(tree.tickExactlyOnce(), NodeStatus::RUNNING);
  EXPECT_EQ(tree.tickExactlyOnce(), NodeStatus::SUCCESS);
  EXPECT_EQ(TakeEvents(), (std::vector<std::string>{"one", "two", "end of the scope"}));
}

TEST_F(Nodes, ACoroutineThatIsHaltedLeavesItsScopes) {
  BT::Tree tree = factory.createTreeFromText(Main("<Counting/>"));
  tree.tickExactlyOnce();
  tree.haltTree();
  EXPECT_EQ(TakeEvents(), (std::vector<std::string>{"one", "end of the scope"}));
}

TEST_F(Nodes, AThreadReadsAndWritesPorts) {
  BT::Tree tree =
      factory.createTreeFromText(Main("<Thinking question=\"21\" answer=\"{answer}\"/>"));
  EXPECT_EQ(tree.tickWhileRunning(std::chrono::seconds(60)), NodeStatus::SUCCESS);
  EXPECT_EQ(tree.rootBlackboard()->get<int>("answer"), 42);
}

TEST_F(Nodes, AHaltWaitsForTheThreadWhichMayStillWrite) {
  BT::Tree tree = factory.createTreeFromText(Main("<UntilHalted answer=\"{answer}\"/>"));
  tree.tickExactlyOnce();
  tree.haltTree();
  EXPECT_EQ(tree.rootBlackboard()->get<int>("answer"), 1);
}

TEST_F(Nodes, FunctionsAreActionsConditionsAndDecorators) {
  factory.registerSimpleAction("Act", [](BT::TreeNode&) { return NodeStatus::SUCCESS; });
  factory.registerSimpleCondition("Ask", [](BT::TreeNode&) { return NodeStatus::FAILURE; });
  factory.registerSimpleDecorator("Not", [](NodeStatus status, BT::TreeNode&) {
    return status == NodeStatus::SUCCESS ? NodeStatus::FAILURE : NodeStatus::SUCCESS;
  });
  BT::Tree tree = factory.createTreeFromText(Main("<Sequence><Act/><Not><Ask/></Not></Sequence>"));
  EXPECT_EQ(tree.tickOnce(), NodeStatus::SUCCESS);
}

TEST_F(Nodes, AnExceptionLeavesTheTickWithTheNodesPath) {
  factory.registerSimpleAction(
      "Throw", [](BT::TreeNode&) -> NodeStatus { throw std::runtime_error("no power"); });
  BT::Tree tree = factory.createTreeFromText(Main("<Sequence><Throw name=\"t\"/></Sequence>"));
  try {
    tree.tickOnce();
    FAIL();
  } catch (const BT::NodeExecutionError& error) {
    EXPECT_EQ(error.failedNode().node_path, "t");
    EXPECT_EQ(error.originalMessage(), "no power");
  }
  EXPECT_EQ(tree.rootNode()->status(), NodeStatus::IDLE);
}

TEST_F(Nodes, ASyncActionMustNotRun) {
  factory.registerSimpleAction("Run", [](BT::TreeNode&) { return NodeStatus::RUNNING; });
  BT::Tree tree = factory.createTreeFromText(Main("<Run/>"));
  EXPECT_THROW(tree.tickOnce(), BT::RuntimeError);
}

TEST_F(Nodes, BuiltInNodesHaveTheirClasses) {
  BT::Tree tree = factory.createTreeFromText(
      Main("<Sequence name=\"s\"><Inverter><AlwaysFailure/></Inverter></Sequence>"));
  const auto* root = dynamic_cast<BT::SequenceNode*>(tree.rootNode());
  ASSERT_TRUE(root);
  ASSERT_EQ(root->childrenCount(), 1U);
  EXPECT_TRUE(dynamic_cast<const BT::InverterNode*>(root->child(0)));
  EXPECT_EQ(root->child(0)->UID(), 2);
  EXPECT_EQ(root->child(0)->fullPath(), "Inverter::2");
  EXPECT_EQ(root->name(), "s");
}

TEST_F(Nodes, ABuiltInNodeCanHaveASecondName) {
  factory.registerNodeType<BT::RetryNode>("RetryUntilSuccesful");
  BT::Tree tree = factory.createTreeFromText(
      Main("<RetryUntilSuccesful num_attempts=\"2\"><AlwaysFailure/></RetryUntilSuccesful>"));
  EXPECT_EQ(tree.tickOnce(), NodeStatus::FAILURE);
}

TEST_F(Nodes, ATickCanBeReplacedAndWatched) {
  BT::Tree tree = factory.createTreeFromText(
      Main("<Sequence><AlwaysFailure name=\"a\"/><AlwaysFailure name=\"b\"/></Sequence>"));
  int watched = 0;
  tree.applyVisitor([&](BT::TreeNode* node) {
    if (node->name() == "a") {
      node->setPreTickFunction([](BT::TreeNode&) { return NodeStatus::SUCCESS; });
    }
    if (node->name() == "b") {
      node->setPostTickFunction([](BT::TreeNode&, NodeStatus) { return NodeStatus::SUCCESS; });
      node->setTickMonitorCallback(
          [&](BT::TreeNode&, NodeStatus, std::chrono::microseconds) { ++watched; });
    }
  });
  EXPECT_EQ(tree.tickOnce(), NodeStatus::SUCCESS);
  EXPECT_EQ(watched, 1);
}

}  // namespace
