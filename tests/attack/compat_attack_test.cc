// What code that was written for BehaviorTree.CPP may do wrong: the tree says so, and goes on.
#include <gmock/gmock.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <thread>

#include "behaviortree_cpp/bt_factory.h"
#include "behaviortree_cpp/loggers/abstract_logger.h"
#include "behaviortree_cpp/loggers/groot2_publisher.h"

namespace {

using BT::NodeStatus;
using testing::HasSubstr;

// Does in its methods what the test wants.
class Act : public BT::StatefulActionNode {
 public:
  using Deed = std::function<void()>;
  Act(const std::string& name, const BT::NodeConfig& config, Deed* on_running, Deed* on_halted)
      : StatefulActionNode(name, config), on_running_(on_running), on_halted_(on_halted) {}

  static BT::PortsList providedPorts() { return {}; }
  NodeStatus onStart() override { return NodeStatus::RUNNING; }
  NodeStatus onRunning() override {
    if (*on_running_) (*on_running_)();
    return NodeStatus::RUNNING;
  }
  void onHalted() override {
    if (*on_halted_) (*on_halted_)();
  }

 private:
  Deed* on_running_;
  Deed* on_halted_;
};

class Logger : public BT::StatusChangeLogger {
 public:
  Logger(BT::TreeNode* root, Act::Deed deed) : StatusChangeLogger(root), deed_(std::move(deed)) {}
  void callback(BT::Duration, const BT::TreeNode&, NodeStatus, NodeStatus) override { deed_(); }
  void flush() override {}

 private:
  const Act::Deed deed_;
};

class CompatAttack : public testing::Test {
 protected:
  CompatAttack() {
    factory_.registerNodeType<Act>("Act", &on_running_, &on_halted_);
    tree_ = factory_.createTreeFromText(
        R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence><AlwaysSuccess/><Act/>
           </Sequence></BehaviorTree></root>)");
  }

  // What the tick throws; nothing if it runs.
  std::string Tick() {
    try {
      EXPECT_EQ(tree_.tickExactlyOnce(), NodeStatus::RUNNING);
    } catch (const std::exception& error) {
      return error.what();
    } catch (...) {
      return "something";
    }
    return "";
  }

  // Also for other threads, which would wait for ever for a tick that has not ended.
  void ExpectThatItWorks() {
    EXPECT_EQ(Tick(), "");
    std::thread([&] { tree_.rootBlackboard()->set("key", 1); }).join();
    tree_.haltTree();
    EXPECT_EQ(tree_.rootNode()->status(), NodeStatus::IDLE);
  }

  Act::Deed on_running_, on_halted_;
  BT::BehaviorTreeFactory factory_;
  BT::Tree tree_;
};

TEST_F(CompatAttack, WhoWatchesATreeAndThrowsEndsTheTickAndNothingElse) {
  const Act::Deed deeds[] = {[] { throw std::runtime_error("the disk is full"); },
                             [] { throw 42; }};
  for (const Act::Deed& deed : deeds) {
    {
      const Logger logger(tree_.rootNode(), deed);
      EXPECT_NE(Tick(), "");
      EXPECT_NE(Tick(), "");
    }
    ExpectThatItWorks();
  }
}

TEST_F(CompatAttack, WhoWatchesTheEndOfATreeAndThrowsEndsNoProgram) {
  bool throws = false;
  const Logger logger(tree_.rootNode(), [&] {
    if (throws) throw 42;
  });
  EXPECT_EQ(Tick(), "");
  throws = true;
  EXPECT_ANY_THROW(tree_.haltTree());
  throws = false;
  ExpectThatItWorks();
  EXPECT_EQ(Tick(), "");
  throws = true;
  tree_ = BT::Tree();
}

TEST_F(CompatAttack, AFunctionBeforeOrAfterTheTickOfANodeThatThrowsEndsTheTick) {
  tree_.rootNode()->setPreTickFunction(
      [](BT::TreeNode&) -> NodeStatus { throw std::runtime_error("before"); });
  EXPECT_THAT(Tick(), HasSubstr("before"));
  tree_.rootNode()->setPreTickFunction(nullptr);
  ExpectThatItWorks();
  tree_.rootNode()->setPostTickFunction(
      [](BT::TreeNode&, NodeStatus) -> NodeStatus { throw std::runtime_error("after"); });
  EXPECT_THAT(Tick(), HasSubstr("after"));
  tree_.rootNode()->setPostTickFunction(nullptr);
  ExpectThatItWorks();
}

TEST_F(CompatAttack, ANodeThatTicksOrHaltsItsOwnTreeIsToldSo) {
  const Act::Deed deeds[] = {[&] { tree_.tickOnce(); }, [&] { tree_.haltTree(); }};
  for (const Act::Deed& deed : deeds) {
    on_running_ = deed;
    EXPECT_EQ(Tick(), "");
    EXPECT_THAT(Tick(), HasSubstr("by one of its own nodes"));
    on_running_ = nullptr;
    ExpectThatItWorks();
  }
}

TEST_F(CompatAttack, ANodeThatDoesSoWhileItIsHaltedOrThrowsIsHalted) {
  const Act::Deed deeds[] = {[&] { tree_.tickOnce(); }, [&] { tree_.haltTree(); },
                             [] { throw std::runtime_error("stuck"); }, [] { throw 42; }};
  for (const Act::Deed& deed : deeds) {
    on_halted_ = deed;
    EXPECT_EQ(Tick(), "");
    tree_.haltTree();
    on_halted_ = nullptr;
    ExpectThatItWorks();
  }
}

TEST_F(CompatAttack, ATreeWithoutABlackboardIsRefused) {
  EXPECT_THROW(
      factory_.createTreeFromText(
          R"(<root BTCPP_format="4"><BehaviorTree ID="A"><Act/></BehaviorTree></root>)", nullptr),
      BT::RuntimeError);
}

TEST_F(CompatAttack, ABuilderThatMakesNothingMakesNoTree) {
  factory_.registerBuilder({BT::NodeType::ACTION, "Nothing", {}, {}},
                           [](const std::string&, const BT::NodeConfig&) { return nullptr; });
  EXPECT_THROW(
      factory_.createTreeFromText(
          R"(<root BTCPP_format="4"><BehaviorTree ID="A"><Nothing/></BehaviorTree></root>)"),
      BT::RuntimeError);
}

TEST_F(CompatAttack, APortThatThereIsNotIsNoOther) {
  EXPECT_THROW(BT::Groot2Publisher(tree_, 65536 + 1667), BT::RuntimeError);
  ExpectThatItWorks();
}

}  // namespace
