// Factories, loggers and scripts, written as the documentation of BehaviorTree.CPP says.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "behaviortree_cpp/bt_factory.h"
#include "behaviortree_cpp/json_export.h"
#include "behaviortree_cpp/loggers/bt_minitrace_logger.h"
#include "behaviortree_cpp/loggers/bt_observer.h"
#include "behaviortree_cpp/xml_parsing.h"

namespace compat_test {

struct Point {
  int x = 0;
  int y = 0;
};
BT_JSON_CONVERTER(Point, point) {
  add_field("x", &point.x);
  add_field("y", &point.y);
}

}  // namespace compat_test

namespace {

using BT::NodeStatus;
using compat_test::Point;

std::string Main(const std::string& body) {
  return "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">" + body + "</BehaviorTree></root>";
}

std::string TempFile(const std::string& name) {
  return (std::filesystem::path(testing::TempDir()) / name).string();
}

std::string ReadAll(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Factory, ATreeThatIsWrongThrowsWithAllProblems) {
  BT::BehaviorTreeFactory factory;
  try {
    (void)factory.createTreeFromText(Main("<Sequence><Inverter/><Fallbak/></Sequence>"));
    FAIL();
  } catch (const BT::RuntimeError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("Fallback"), std::string::npos) << text;
    EXPECT_NE(text.find("Inverter"), std::string::npos) << text;
  }
}

TEST(Factory, RegisteredTreesFindEachOther) {
  BT::BehaviorTreeFactory factory;
  factory.registerBehaviorTreeFromText(Main("<SubTree ID=\"Other\"/>"));
  factory.registerBehaviorTreeFromText(
      "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Other\"><AlwaysFailure/></BehaviorTree></root>");
  EXPECT_EQ(factory.registeredBehaviorTrees(), (std::vector<std::string>{"Main", "Other"}));
  EXPECT_EQ(factory.createTree("Main").tickOnce(), NodeStatus::FAILURE);
  factory.clearRegisteredBehaviorTrees();
  EXPECT_THROW((void)factory.createTree("Main"), BT::RuntimeError);
}

TEST(Factory, AnIdCanBeTakenOnce) {
  BT::BehaviorTreeFactory factory;
  const auto yes = [](BT::TreeNode&) { return NodeStatus::SUCCESS; };
  factory.registerSimpleAction("Act", yes);
  EXPECT_THROW(factory.registerSimpleAction("Act", yes), BT::BehaviorTreeException);
  EXPECT_TRUE(factory.unregisterBuilder("Act"));
  factory.registerSimpleAction("Act", yes);
  EXPECT_THROW(factory.unregisterBuilder("Sequence"), BT::LogicError);
}

TEST(Factory, ATreeCanBeMoved) {
  BT::BehaviorTreeFactory factory;
  BT::Tree tree;
  EXPECT_THROW(tree.tickOnce(), BT::RuntimeError);
  tree = factory.createTreeFromText(Main("<AlwaysSuccess/>"));
  BT::Tree moved = std::move(tree);
  EXPECT_EQ(moved.tickOnce(), NodeStatus::SUCCESS);
}

TEST(Factory, RulesPutOtherNodesInTheirPlace) {
  BT::BehaviorTreeFactory factory;
  std::vector<std::string> paths;
  factory.registerSimpleAction("Stand", [&](BT::TreeNode& node) {
    paths.push_back(node.fullPath());
    return NodeStatus::SUCCESS;
  });
  BT::TestNodeConfig test;
  test.return_status_script = "n == 1 ? FAILURE : SUCCESS";
  test.failure_script = "failed := true";
  factory.addSubstitutionRule("a*", "Stand");
  factory.addSubstitutionRule("all", test);
  BT::Tree tree = factory.createTreeFromText(
      Main("<Sequence><AlwaysFailure name=\"a1\"/><Script code=\"n := 1\"/>"
           "<Sequence name=\"all\"><AlwaysSuccess name=\"x\"/></Sequence></Sequence>"));
  EXPECT_EQ(tree.tickOnce(), NodeStatus::FAILURE);
  EXPECT_EQ(paths, (std::vector<std::string>{"a1"}));
  EXPECT_TRUE(tree.rootBlackboard()->get<bool>("failed"));
}

TEST(Factory, RulesAreReadFromJson) {
  BT::BehaviorTreeFactory factory;
  factory.loadSubstitutionRuleFromJSON(
      R"({"TestNodeConfigs": {"Good": {"return_status": "SUCCESS"}},
          "SubstitutionRules": {"bad": "Good"}})");
  EXPECT_EQ(factory.createTreeFromText(Main("<AlwaysFailure name=\"bad\"/>")).tickOnce(),
            NodeStatus::SUCCESS);
}

TEST(Factory, ModelsAndTreesAreWritten) {
  BT::BehaviorTreeFactory factory;
  factory.registerSimpleAction("Act", [](BT::TreeNode&) { return NodeStatus::SUCCESS; },
                               {BT::InputPort<int>("n", 3, "how many")});
  EXPECT_EQ(BT::writeTreeNodesModelXML(factory),
            "<root BTCPP_format=\"4\">\n    <TreeNodesModel>\n        <Action ID=\"Act\">\n"
            "            <input_port name=\"n\" type=\"int\" default=\"3\">how many</input_port>\n"
            "        </Action>\n    </TreeNodesModel>\n</root>\n");
  const BT::Tree tree = factory.createTreeFromText(Main("<Inverter><Act n=\"{k}\"/></Inverter>"));
  EXPECT_NE(BT::WriteTreeToXML(tree, false, false)
                .find("        <Inverter name=\"Inverter\">\n"
                      "            <Act name=\"Act\" n=\"{k}\"/>\n        </Inverter>\n"),
            std::string::npos)
      << BT::WriteTreeToXML(tree, false, false);
}

// ---- Loggers.

class Transitions : public BT::StatusChangeLogger {
 public:
  explicit Transitions(const BT::Tree& tree) : StatusChangeLogger(tree.rootNode()) {}
  ~Transitions() override { unsubscribeFromTreeChanges(); }
  void callback(BT::Duration, const BT::TreeNode& node, NodeStatus before,
                NodeStatus status) override {
    all.push_back(node.name() + " " + toStr(before) + " " + toStr(status));
  }
  void flush() override {}
  std::vector<std::string> all;
};

TEST(Loggers, EveryChangeIsToldInItsOrder) {
  BT::BehaviorTreeFactory factory;
  BT::Tree tree = factory.createTreeFromText(
      Main("<Sequence name=\"s\"><AlwaysSuccess name=\"a\"/><AlwaysFailure name=\"b\"/>"
           "</Sequence>"));
  Transitions logger(tree);
  tree.tickOnce();
  EXPECT_EQ(logger.all, (std::vector<std::string>{
                            "s IDLE RUNNING", "a IDLE SUCCESS", "b IDLE FAILURE", "a SUCCESS IDLE",
                            "b FAILURE IDLE", "s RUNNING FAILURE", "s FAILURE IDLE"}));
}

TEST(Loggers, AFunctionAsActionIsShownRunningFirst) {
  BT::BehaviorTreeFactory factory;
  factory.registerSimpleAction("Do", [](BT::TreeNode&) { return NodeStatus::SUCCESS; });
  BT::Tree tree = factory.createTreeFromText(Main("<Do name=\"a\"/>"));
  Transitions logger(tree);
  tree.tickOnce();
  EXPECT_EQ(logger.all,
            (std::vector<std::string>{"a IDLE RUNNING", "a RUNNING SUCCESS", "a SUCCESS IDLE"}));
}

TEST(Loggers, ALoggerThatHasGoneIsNotCalled) {
  BT::BehaviorTreeFactory factory;
  BT::Tree tree = factory.createTreeFromText(Main("<AlwaysSuccess/>"));
  { const Transitions logger(tree); }
  EXPECT_EQ(tree.tickOnce(), NodeStatus::SUCCESS);
}

TEST(Loggers, AnObserverCounts) {
  BT::BehaviorTreeFactory factory;
  BT::Tree tree =
      factory.createTreeFromText(Main("<Inverter><AlwaysFailure name=\"a\"/></Inverter>"));
  BT::TreeObserver observer(tree);
  tree.tickOnce();
  tree.tickOnce();
  EXPECT_EQ(observer.getStatistics("a").failure_count, 2U);
  EXPECT_EQ(observer.getStatistics(1).success_count, 2U);
  EXPECT_EQ(observer.getStatistics(1).transitions_count, 4U);
}

TEST(Loggers, ATraceIsJson) {
  const std::string path = TempFile("compat.json");
  BT::BehaviorTreeFactory factory;
  BT::Tree tree = factory.createTreeFromText(Main("<Inverter><AlwaysSuccess/></Inverter>"));
  {
    BT::MinitraceLogger logger(tree, path.c_str());
    tree.tickOnce();
  }
  const auto json = nlohmann::json::parse(ReadAll(path));
  EXPECT_EQ(json["traceEvents"].size(), 3U);
  std::filesystem::remove(path);
}

// ---- Scripts.

TEST(Scripts, AScriptRunsOnABlackboard) {
  BT::Ast::Environment environment{BT::Blackboard::create(), nullptr};
  const auto result = BT::ParseScriptAndExecute(environment, "a := 3; b := a * 2; b + 1");
  ASSERT_TRUE(result) << result.error();
  EXPECT_EQ(result->cast<int>(), 7);
  EXPECT_EQ(environment.vars->get<int>("b"), 6);
}

TEST(Scripts, WhatIsNoScriptIsSaid) {
  EXPECT_TRUE(BT::ValidateScript("a := 1"));
  EXPECT_FALSE(BT::ValidateScript("a := := 1"));
  EXPECT_FALSE(BT::ParseScript("'"));
}

// ---- JSON.

TEST(Json, ATypeOfTheUserGoesToJsonAndBack) {
  BT::RegisterJsonDefinition<Point>();
  nlohmann::json json;
  ASSERT_TRUE(BT::JsonExporter::get().toJson(BT::Any(Point{1, 2}), json));
  EXPECT_EQ(json.dump(), R"({"__type":"Point","x":1,"y":2})");
  const auto back = BT::JsonExporter::get().fromJson<Point>(json);
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(back->y, 2);
  EXPECT_EQ(BT::convertFromString<Point>("json:{\"x\":5,\"y\":6}").x, 5);
}

TEST(Json, ABlackboardGoesToJsonAndBack) {
  const auto board = BT::Blackboard::create();
  board->set("n", 1);
  board->set("list", std::vector<double>{1.5, 2});
  const auto json = BT::ExportBlackboardToJSON(*board);
  const auto copy = BT::Blackboard::create();
  BT::ImportBlackboardFromJSON(json, *copy);
  EXPECT_EQ(copy->get<int>("n"), 1);
  EXPECT_EQ(copy->get<std::vector<double>>("list").size(), 2U);
}

}  // namespace
