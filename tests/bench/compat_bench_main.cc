// What the interface of BehaviorTree.CPP costs, for callgrind:
//   coppice_compat_bench CASE ROUNDS
// reads or writes a port 1000 times in each round, or ticks the tree of the case "tick" once. It
// uses nothing but that interface, so it can be built against BehaviorTree.CPP, too.
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <string>

#include "behaviortree_cpp/bt_factory.h"

namespace {

enum class Color { kRed = 1, kGreen = 2, kBlue = 3 };

constexpr int kReads = 1000;

// Its ports are read by the case that was chosen, `rounds` times.
class Reader : public BT::SyncActionNode {
 public:
  using Case = std::function<void(Reader&, int rounds)>;
  Reader(const std::string& name, const BT::NodeConfig& config, Case chosen, int rounds)
      : SyncActionNode(name, config), case_(std::move(chosen)), rounds_(rounds) {}

  static BT::PortsList providedPorts() {
    return {BT::InputPort<int>("count"),           BT::InputPort<int>("count_key"),
            BT::InputPort<double>("speed"),        BT::InputPort<double>("speed_key"),
            BT::InputPort<bool>("slow"),           BT::InputPort<bool>("slow_key"),
            BT::InputPort<std::string>("message"), BT::InputPort<std::string>("message_key"),
            BT::InputPort<Color>("color"),         BT::InputPort<Color>("color_key"),
            BT::OutputPort<double>("out")};
  }
  BT::NodeStatus tick() override {
    case_(*this, rounds_);
    return BT::NodeStatus::SUCCESS;
  }

 private:
  Case case_;
  int rounds_;
};

template <class T>
Reader::Case Get(const std::string& port) {
  return [port](Reader& node, int rounds) {
    T value{};
    for (int i = 0; i < rounds * kReads; ++i) {
      if (!node.getInput(port, value)) std::abort();
    }
  };
}

// As a result of its own, by a literal name.
void GetExpected(Reader& node, int rounds) {
  double sum = 0;
  for (int i = 0; i < rounds * kReads; ++i) sum += node.getInput<double>("speed_key").value();
  if (sum < 0) std::abort();
}

void SetDouble(Reader& node, int rounds) {
  const std::string out = "out";
  for (int i = 0; i < rounds * kReads; ++i) {
    if (!node.setOutput(out, 0.5 * i)) std::abort();
  }
}

// What a copy costs, which no way of reading a text can avoid.
void CopyText(Reader&, int rounds) {
  const std::string from = "come closer, please, and speak up";
  std::string to;
  for (int i = 0; i < rounds * kReads; ++i) {
    asm volatile("" : : "r"(&from), "r"(&to) : "memory");
    to = from;
  }
}

const std::map<std::string, Reader::Case>& Cases() {
  static const std::map<std::string, Reader::Case> cases = {
      {"int literal", Get<int>("count")},
      {"int key", Get<int>("count_key")},
      {"double literal", Get<double>("speed")},
      {"double key", Get<double>("speed_key")},
      {"bool literal", Get<bool>("slow")},
      {"bool key", Get<bool>("slow_key")},
      {"string literal", Get<std::string>("message")},
      {"string key", Get<std::string>("message_key")},
      {"enum literal", Get<Color>("color")},
      {"enum key", Get<Color>("color_key")},
      {"expected double key", &GetExpected},
      {"set double", &SetDouble},
      {"copy of the string", &CopyText},
  };
  return cases;
}

int ReadPorts(const Reader::Case& chosen, int rounds) {
  BT::BehaviorTreeFactory factory;
  factory.registerScriptingEnum("GREEN", static_cast<int>(Color::kGreen));
  factory.registerNodeType<Reader>("Reader", chosen, rounds);
  factory.registerSimpleAction(
      "Prepare",
      [](BT::TreeNode& node) {
        node.setOutput("count", 7);
        node.setOutput("speed", 1.5);
        node.setOutput("slow", true);
        node.setOutput("message", std::string("come closer, please, and speak up"));
        node.setOutput("color", Color::kBlue);
        return BT::NodeStatus::SUCCESS;
      },
      {BT::OutputPort<int>("count"), BT::OutputPort<double>("speed"), BT::OutputPort<bool>("slow"),
       BT::OutputPort<std::string>("message"), BT::OutputPort<Color>("color")});
  BT::Tree tree = factory.createTreeFromText(R"(
    <root BTCPP_format="4">
      <BehaviorTree ID="Main">
        <Sequence>
          <Prepare count="{c}" speed="{s}" slow="{b}" message="{m}" color="{k}"/>
          <Reader count="7" count_key="{c}" speed="1.5" speed_key="{s}" slow="true" slow_key="{b}"
                  message="come closer, please, and speak up" message_key="{m}"
                  color="GREEN" color_key="{k}" out="{o}"/>
        </Sequence>
      </BehaviorTree>
    </root>)");
  return tree.tickExactlyOnce() == BT::NodeStatus::SUCCESS ? 0 : 1;
}

class Yes : public BT::ConditionNode {
 public:
  using ConditionNode::ConditionNode;
  static BT::PortsList providedPorts() { return {}; }
  BT::NodeStatus tick() override { return BT::NodeStatus::SUCCESS; }
};

class Drive : public BT::StatefulActionNode {
 public:
  using StatefulActionNode::StatefulActionNode;
  static BT::PortsList providedPorts() { return {}; }
  BT::NodeStatus onStart() override { return BT::NodeStatus::RUNNING; }
  BT::NodeStatus onRunning() override { return BT::NodeStatus::RUNNING; }
  void onHalted() override {}
};

// 99 conditions and an action that runs, below 11 reactive sequences.
int TickTree(int rounds) {
  std::string groups;
  for (int group = 0; group < 10; ++group) {
    groups += "<ReactiveSequence>";
    for (int leaf = 0; leaf < 9; ++leaf) groups += "<Yes/>";
    groups += group == 9 ? "<Drive/>" : "<Yes/>";
    groups += "</ReactiveSequence>";
  }
  BT::BehaviorTreeFactory factory;
  factory.registerNodeType<Yes>("Yes");
  factory.registerNodeType<Drive>("Drive");
  BT::Tree tree = factory.createTreeFromText(
      "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><ReactiveSequence>" + groups +
      "</ReactiveSequence></BehaviorTree></root>");
  for (int round = 0; round < rounds; ++round) {
    if (tree.tickExactlyOnce() != BT::NodeStatus::RUNNING) return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc == 3 ? argv[1] : "";
  const int rounds = argc == 3 ? std::atoi(argv[2]) : 0;
  if (name == "tick") return TickTree(rounds);
  const auto found = Cases().find(name);
  if (found != Cases().end()) return ReadPorts(found->second, rounds);
  std::cerr << "usage: coppice_compat_bench CASE ROUNDS\ncases: tick";
  for (const auto& known : Cases()) std::cerr << ", " << known.first;
  std::cerr << "\n";
  return 2;
}
