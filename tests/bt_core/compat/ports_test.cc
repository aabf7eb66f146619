// Ports and blackboards, written as the documentation of BehaviorTree.CPP says.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "behaviortree_cpp/bt_factory.h"
#include "behaviortree_cpp/json_export.h"

namespace compat_test {

struct Pose {
  double x = 0;
  double y = 0;
};

enum class Colour { kRed = 1, kBlue = 2 };

struct Animal {
  virtual ~Animal() = default;
};
struct Cat : Animal {};
struct Sphynx : Cat {};

}  // namespace compat_test

namespace {

using BT::NodeStatus;
using compat_test::Animal;
using compat_test::Cat;
using compat_test::Colour;
using compat_test::Pose;
using compat_test::Sphynx;

std::string Main(const std::string& body) {
  return "<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\"><BehaviorTree ID=\"Main\">" +
         body + "</BehaviorTree>";
}

}  // namespace

namespace BT {
template <>
inline compat_test::Pose convertFromString(StringView text) {
  const auto parts = splitString(text, ';');
  if (parts.size() != 2) throw RuntimeError("a pose has two numbers");
  return {convertFromString<double>(parts[0]), convertFromString<double>(parts[1])};
}
}  // namespace BT

namespace {

// A leaf whose tick is a function, with the ports of the test.
struct Ports : testing::Test {
  using Function = std::function<void(BT::TreeNode&)>;
  void Register(const std::string& id, BT::PortsList ports, Function function) {
    factory.registerSimpleAction(
        id,
        [function](BT::TreeNode& node) {
          function(node);
          return NodeStatus::SUCCESS;
        },
        std::move(ports));
  }
  BT::Tree Create(const std::string& body) {
    return factory.createTreeFromText(Main(body) + "</root>");
  }
  BT::BehaviorTreeFactory factory;
};

TEST_F(Ports, ALiteralIsReadAsThePortsType) {
  double x = 0;
  Register("Go", {BT::InputPort<Pose>("to")},
           [&](BT::TreeNode& node) { x = node.getInput<Pose>("to").value().x; });
  Create("<Go to=\"1.5;2\"/>").tickOnce();
  EXPECT_EQ(x, 1.5);
}

TEST_F(Ports, ALiteralThatIsNoneIsSaidWhenTheTreeIsMade) {
  Register("Go", {BT::InputPort<Pose>("to")}, [](BT::TreeNode&) {});
  try {
    Create("<Go to=\"1.5\"/>");
    FAIL();
  } catch (const BT::LogicError& error) {
    EXPECT_NE(std::string(error.what()).find(":1:"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("a pose has two numbers"), std::string::npos);
  }
}

TEST_F(Ports, APortCanBeReadAsAnotherType) {
  std::string text;
  int number = 0;
  Register("Go", {BT::InputPort<int>("a"), BT::InputPort<std::string>("b")},
           [&](BT::TreeNode& node) {
             text = node.getInput<std::string>("a").value();
             number = node.getInput<int>("b").value();
           });
  Create("<Go a=\"007\" b=\"8\"/>").tickOnce();
  EXPECT_EQ(text, "7");  // it is an int
  EXPECT_EQ(number, 8);
}

TEST_F(Ports, SmallNumbersKeepTheirRange) {
  bool fits = true;
  BT::Result small;
  Register("Go", {BT::InputPort<int>("n")}, [&](BT::TreeNode& node) {
    uint8_t out = 0;
    small = node.getInput("n", out);
    fits = small.has_value();
  });
  Create("<Sequence><Script code=\"n := 300\"/><Go n=\"{n}\"/></Sequence>").tickOnce();
  EXPECT_FALSE(fits);
}

TEST_F(Ports, AnUnknownPortIsAnErrorNotAThrow) {
  BT::Expected<int> missing;
  Register("Go", {BT::InputPort<int>("a")},
           [&](BT::TreeNode& node) { missing = node.getInput<int>("b"); });
  Create("<Go a=\"1\"/>").tickOnce();
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().find("no input port [b]"), std::string::npos) << missing.error();
}

TEST_F(Ports, WhatIsExpectedCanBeCompared) {
  const BT::Expected<int> seven = 7;
  const BT::Expected<int> none = nonstd::make_unexpected(std::string("none"));
  EXPECT_TRUE(seven == 7 && 7 == seven && seven != 8);
  EXPECT_TRUE(none != 7 && !(none == 7) && none != seven);
  EXPECT_TRUE(seven == BT::Expected<int>(7) && none == none);
}

TEST_F(Ports, DefaultsAreValuesTextsAndKeys) {
  std::vector<int> values;
  Register("Go",
           {BT::InputPort<int>("a", 1, ""), BT::InputPort<int>("b", "2", ""),
            BT::InputPort<int>("c", "{key}", ""), BT::InputPort<int>("d", "{=}", "")},
           [&](BT::TreeNode& node) {
             for (const char* port : {"a", "b", "c", "d"}) {
               values.push_back(node.getInput<int>(port).value());
             }
           });
  BT::Tree tree = Create("<Go/>");
  tree.rootBlackboard()->set("key", 3);
  tree.rootBlackboard()->set("d", 4);
  tree.tickOnce();
  EXPECT_EQ(values, (std::vector<int>{1, 2, 3, 4}));
}

TEST_F(Ports, EnumsAreReadByTheNamesOfScripts) {
  factory.registerScriptingEnums<Colour>();
  Colour colour{};
  Register("Go", {BT::InputPort<Colour>("colour")},
           [&](BT::TreeNode& node) { colour = node.getInput<Colour>("colour").value(); });
  Create("<Go colour=\"kBlue\"/>").tickOnce();
  EXPECT_EQ(colour, Colour::kBlue);
  Create("<Sequence><Script code=\"c := kRed\"/><Go colour=\"{c}\"/></Sequence>").tickOnce();
  EXPECT_EQ(colour, Colour::kRed);
}

TEST_F(Ports, AnEnumsLiteralMayBeANumber) {
  Colour colour{};
  Register("Go", {BT::InputPort<Colour>("colour")},
           [&](BT::TreeNode& node) { colour = node.getInput<Colour>("colour").value(); });
  Create("<Go colour=\"2\"/>").tickOnce();
  EXPECT_EQ(colour, Colour::kBlue);
}

TEST_F(Ports, ANameOfAnEnumCanBeRegisteredAfterTheTreeIsMade) {
  BT::Expected<Colour> colour;
  Register("Go", {BT::InputPort<Colour>("colour")},
           [&](BT::TreeNode& node) { colour = node.getInput<Colour>("colour"); });
  BT::Tree tree = Create("<Go colour=\"kBlue\"/>");
  tree.tickOnce();
  EXPECT_FALSE(colour);
  factory.registerScriptingEnums<Colour>();
  tree.tickOnce();
  EXPECT_EQ(colour.value(), Colour::kBlue);
}

TEST_F(Ports, ALiteralOfAnEnumIsAlsoReadAsItsText) {
  factory.registerScriptingEnums<Colour>();
  std::string text;
  Register("Go", {BT::InputPort<Colour>("colour")},
           [&](BT::TreeNode& node) { text = node.getInput<std::string>("colour").value(); });
  Create("<Go colour=\"kBlue\"/>").tickOnce();
  EXPECT_EQ(text, "kBlue");
}

TEST_F(Ports, ANumberOfAScriptIsReadAsTheNodeWantsIt) {
  int whole = 0;
  uint8_t small = 0;
  BT::Expected<int> half;
  Register("Go", {BT::InputPort<int>("n"), BT::InputPort<int>("half")}, [&](BT::TreeNode& node) {
    whole = node.getInput<int>("n").value();
    small = node.getInput<uint8_t>("n").value();
    half = node.getInput<int>("half");
  });
  Create(
      "<Sequence><Script code=\"n := 3.0; half := 0.5\"/><Go n=\"{n}\" half=\"{half}\"/>"
      "</Sequence>")
      .tickOnce();
  EXPECT_EQ(whole, 3);
  EXPECT_EQ(small, 3);
  EXPECT_FALSE(half);
}

TEST_F(Ports, AnEnumThatANodeWritesIsANumberInScripts) {
  factory.registerScriptingEnums<Colour>();
  Register("Paint", {BT::OutputPort<Colour>("colour")},
           [](BT::TreeNode& node) { node.setOutput("colour", Colour::kBlue); });
  EXPECT_EQ(Create("<Sequence><Paint colour=\"{c}\"/><ScriptCondition code=\"c == kBlue\"/>"
                   "</Sequence>")
                .tickOnce(),
            NodeStatus::SUCCESS);
}

TEST_F(Ports, TwoTypesOfOneKeyAreRefused) {
  Register("A", {BT::OutputPort<int>("k")}, [](BT::TreeNode&) {});
  Register("B", {BT::InputPort<Pose>("k")}, [](BT::TreeNode&) {});
  EXPECT_THROW(Create("<Sequence><A k=\"{k}\"/><B k=\"{k}\"/></Sequence>"), BT::RuntimeError);
}

TEST_F(Ports, AKeyOfABuiltInPortKeepsItsType) {
  Register("Write", {BT::OutputPort<std::string>("k")},
           [](BT::TreeNode& node) { node.setOutput("k", std::string("2")); });
  int rounds = 0;
  Register("Count", {}, [&](BT::TreeNode&) { ++rounds; });
  Create("<Sequence><Write k=\"{n}\"/><Repeat num_cycles=\"{n}\"><Count/></Repeat></Sequence>")
      .tickOnce();
  EXPECT_EQ(rounds, 2);
}

TEST_F(Ports, ARunOfPointersGoesUpwards) {
  factory.registerPolymorphicCast<Cat, Animal>();
  factory.registerPolymorphicCast<Sphynx, Cat>();
  bool has = false;
  Register("Make", {BT::OutputPort<std::shared_ptr<Sphynx>>("cat")},
           [](BT::TreeNode& node) { node.setOutput("cat", std::make_shared<Sphynx>()); });
  Register("Use", {BT::InputPort<std::shared_ptr<Animal>>("animal")}, [&](BT::TreeNode& node) {
    has = node.getInput<std::shared_ptr<Animal>>("animal").value() != nullptr;
  });
  Create("<Sequence><Make cat=\"{c}\"/><Use animal=\"{c}\"/></Sequence>").tickOnce();
  EXPECT_TRUE(has);
}

TEST_F(Ports, AValueIsChangedInPlace) {
  Register("Push", {BT::BidirectionalPort<std::vector<int>>("list")}, [](BT::TreeNode& node) {
    BT::AnyPtrLocked any = node.getLockedPortContent("list");
    ASSERT_TRUE(any);
    if (any->empty()) {
      any.assign(std::vector<int>{1});
    } else {
      any->castPtr<std::vector<int>>()->push_back(2);
    }
  });
  BT::Tree tree = Create("<Sequence><Push list=\"{l}\"/><Push list=\"{l}\"/></Sequence>");
  tree.tickOnce();
  EXPECT_EQ(tree.rootBlackboard()->get<std::vector<int>>("l"), (std::vector<int>{1, 2}));
}

TEST_F(Ports, AStampCountsTheWrites) {
  std::vector<uint64_t> stamps;
  Register("Write", {BT::OutputPort<int>("k")}, [](BT::TreeNode& node) { node.setOutput("k", 1); });
  Register("Read", {BT::InputPort<int>("k")}, [&](BT::TreeNode& node) {
    stamps.push_back(node.getInputStamped<int>("k").value().stamp.seq);
  });
  Create(
      "<Sequence><Write k=\"{k}\"/><Read k=\"{k}\"/><Write k=\"{k}\"/><Read k=\"{k}\"/>"
      "</Sequence>")
      .tickOnce();
  EXPECT_EQ(stamps, (std::vector<uint64_t>{1, 2}));
}

// ---- Blackboards.

TEST(Blackboard, AKeyKeepsItsType) {
  const auto board = BT::Blackboard::create();
  board->set("n", 1);
  EXPECT_THROW(board->set("n", std::string("one")), BT::LogicError);
  board->set("n", std::string("2"));
  EXPECT_EQ(board->get<int>("n"), 2);
  board->set("n", 3.0);
  EXPECT_EQ(board->get<int>("n"), 3);
  EXPECT_THROW(board->set("n", 3.5), BT::LogicError);
}

TEST(Blackboard, AMissingKeyThrowsOrIsFalse) {
  const auto board = BT::Blackboard::create();
  int value = 7;
  EXPECT_FALSE(board->get("n", value));
  EXPECT_EQ(value, 7);
  EXPECT_THROW((void)board->get<int>("n"), BT::RuntimeError);
  EXPECT_FALSE(board->getEntry("n"));
}

TEST(Blackboard, ARemappedKeyIsThatOfTheParent) {
  const auto outer = BT::Blackboard::create();
  const auto inner = BT::Blackboard::create(outer);
  inner->addSubtreeRemapping("in", "out");
  inner->set("in", 5);
  EXPECT_EQ(outer->get<int>("out"), 5);
  inner->enableAutoRemapping(true);
  outer->set("other", 6);
  EXPECT_EQ(inner->get<int>("other"), 6);
}

TEST(Blackboard, AnUnsetKeyIsGone) {
  const auto board = BT::Blackboard::create();
  board->set("n", 1);
  board->unset("n");
  EXPECT_TRUE(board->getKeys().empty());
  board->set("n", std::string("now a text"));
  EXPECT_EQ(board->get<std::string>("n"), "now a text");
}

TEST_F(Ports, ABlackboardOutlivesItsTreeWithItsValues) {
  const auto board = BT::Blackboard::create();
  board->set("n", 20);
  {
    BT::Tree tree =
        factory.createTreeFromText(Main("<Script code=\"n += 1; m := 2\"/>") + "</root>", board);
    tree.tickOnce();
    EXPECT_EQ(board->get<int>("n"), 21);
  }
  EXPECT_EQ(board->get<int>("n"), 21);
  EXPECT_EQ(board->get<int>("m"), 2);
}

TEST_F(Ports, TwoTreesShareABlackboard) {
  const auto board = BT::Blackboard::create();
  BT::Tree first = factory.createTreeFromText(Main("<Script code=\"n := 1\"/>") + "</root>", board);
  BT::Tree second =
      factory.createTreeFromText(Main("<Script code=\"n += 1\"/>") + "</root>", board);
  first.tickOnce();
  second.tickOnce();
  EXPECT_EQ(board->get<int>("n"), 2);
}

TEST_F(Ports, TheOutermostBlackboardIsReachedByAnAtSign) {
  const auto global = BT::Blackboard::create();
  const auto board = BT::Blackboard::create(global);
  global->set("value", 3);
  BT::Tree tree = factory.createTreeFromText(
      Main("<Script code=\"value := 10; @square := @value * @value\"/>") + "</root>", board);
  tree.tickOnce();
  EXPECT_EQ(global->get<int>("square"), 9);
  EXPECT_EQ(board->get<int>("value"), 10);
  EXPECT_EQ(global->get<int>("value"), 3);
}

TEST_F(Ports, ASubTreeHasABlackboardOfItsOwn) {
  BT::Tree tree = factory.createTreeFromText(
      Main("<SubTree ID=\"Sub\" in=\"{out}\" text=\"7\"/>") +
      "<BehaviorTree ID=\"Sub\"><Script code=\"in := 1; mine := 2\"/></BehaviorTree></root>");
  tree.tickOnce();
  ASSERT_EQ(tree.subtrees.size(), 2U);
  EXPECT_EQ(tree.subtrees[0]->blackboard->get<int>("out"), 1);
  EXPECT_EQ(tree.subtrees[1]->blackboard->get<int>("in"), 1);
  EXPECT_EQ(tree.subtrees[1]->blackboard->get<int>("mine"), 2);
  EXPECT_EQ(tree.subtrees[1]->blackboard->get<int>("text"), 7);
  EXPECT_FALSE(tree.subtrees[0]->blackboard->getEntry("mine"));
}

TEST_F(Ports, ABackupGivesAllValuesBack) {
  BT::Tree tree = Create("<Script code=\"n := 1\"/>");
  const auto backup = BT::BlackboardBackup(tree);
  tree.tickOnce();
  EXPECT_EQ(tree.rootBlackboard()->get<int>("n"), 1);
  BT::BlackboardRestore(backup, tree);
  EXPECT_FALSE(tree.rootBlackboard()->getEntry("n"));
}

// ---- Any.

TEST(Any, NumbersAreCastIfNothingIsLost) {
  EXPECT_EQ(BT::Any(42).cast<double>(), 42.0);
  EXPECT_EQ(BT::Any(42.0).cast<int>(), 42);
  EXPECT_THROW((void)BT::Any(42.5).cast<int>(), std::runtime_error);
  EXPECT_THROW((void)BT::Any(-1).cast<unsigned>(), std::runtime_error);
  EXPECT_THROW((void)BT::Any(300).cast<uint8_t>(), std::runtime_error);
  EXPECT_THROW((void)BT::Any(std::numeric_limits<int64_t>::max()).cast<double>(),
               std::runtime_error);
  EXPECT_EQ(BT::Any("12").cast<int>(), 12);
  EXPECT_EQ(BT::Any(1.5).cast<std::string>(), "1.500000");
}

TEST(Any, TypesAreKnown) {
  EXPECT_TRUE(BT::Any(1).isType<int>());
  EXPECT_TRUE(BT::Any(1).isIntegral());
  EXPECT_EQ(BT::Any(1).castedType(), typeid(int64_t));
  EXPECT_TRUE(BT::Any("a").isString());
  EXPECT_TRUE(BT::Any().empty());
}

}  // namespace
