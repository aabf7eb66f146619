#include "bt_core/engine/compile/check_project.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

std::string Tree(const std::string& id, const std::string& body) {
  return "<BehaviorTree ID=\"" + id + "\">" + body + "</BehaviorTree>\n";
}

Diagnostics ProblemsOf(const std::string& trees, const CheckOptions& options = {}) {
  Diagnostics diagnostics;
  auto project =
      Project::FromText("<root BTCPP_format=\"4\">\n" + trees + "</root>", "t.xml", diagnostics);
  CheckProject(std::make_shared<const Project>(*std::move(project)), TestRegistry(), options,
               diagnostics);
  return diagnostics;
}

std::string Check(const std::string& trees, const CheckOptions& options = {}) {
  return ProblemsOf(trees, options).ToString();
}

TEST(CheckProject, ChecksEveryTreeAndSaysEachProblemOnce) {
  EXPECT_EQ(Check(Tree("A", R"(<Sequence><SubTree ID="B"/><SubTree ID="B"/></Sequence>)") +
                  Tree("B", "<Inverter/>") + Tree("C", "<Sequence/>")),
            "t.xml:3:22: error: Inverter has 0 children, expected exactly 1\n"
            "t.xml:4:22: error: Sequence has 0 children, expected at least 1\n");
}

TEST(CheckProject, TreesThatUseEachOtherInACircleAreChecked) {
  EXPECT_EQ(Check(Tree("A", R"(<SubTree ID="B"/>)") + Tree("B", R"(<SubTree ID="A"/>)")),
            "t.xml:3:22: error: tree \"A\" contains itself (A -> B -> A)\n");
}

TEST(CheckProject, AnUnknownLeafIsOneWarningForItsType) {
  EXPECT_EQ(Check(Tree("A", R"(<Sequence><Say text="a"/><Say text="b"/></Sequence>)")),
            R"(t.xml:2:32: warning: node type "Say" is not built in: its ports are )"
            "not checked\n");
}

TEST(CheckProject, WhatIsInsideOfAnUnknownControlNodeIsChecked) {
  EXPECT_EQ(
      Check(Tree("A", "<Elsewhere><Inverter/></Elsewhere>")),
      R"(t.xml:2:22: warning: node type "Elsewhere" is not built in: its ports are not checked, )"
      "nor how many children it may have\n"
      "t.xml:2:33: error: Inverter has 0 children, expected exactly 1\n");
}

TEST(CheckProject, ABuiltInNodeThatWouldFitIsSuggested) {
  EXPECT_EQ(
      Check(Tree("A", "<Sequense><Inverterr/></Sequense>")),
      R"(t.xml:2:22: warning: node type "Sequense" is not built in: its ports are not checked, )"
      "nor how many children it may have (did you mean \"Sequence\"?)\n"
      R"(t.xml:2:32: warning: node type "Inverterr" is not built in: its ports are not )"
      "checked\n");
}

TEST(CheckProject, ABuiltInNodeInTheWrongCaseIsAnError) {
  EXPECT_EQ(Check(Tree("A", "<sequence><AlwaysSuccess/></sequence>")),
            "t.xml:2:22: error: unknown node type \"sequence\" (did you mean \"Sequence\"?)\n");
}

TEST(CheckProject, UnknownTypesAreErrorsIfAllAreKnown) {
  EXPECT_EQ(Check(Tree("A", R"(<Drvie goal="1"/>)"), {true}),
            "t.xml:2:22: error: unknown node type \"Drvie\" (did you mean \"Drive\"?)\n");
}

TEST(CheckProject, AMissingSubTreeIsAWarning) {
  EXPECT_EQ(Check(Tree("A", R"(<SubTree ID="Elsewhere"/>)")),
            "t.xml:2:22: warning: tree \"Elsewhere\" is not among these files\n");
}

TEST(CheckProject, TheModelOfALeafTellsItsPorts) {
  const std::string model =
      R"(<TreeNodesModel><Condition ID="IsDark"><input_port name="limit"/></Condition>)"
      "</TreeNodesModel>";
  EXPECT_EQ(Check(Tree("A", R"(<IsDark limit="3"/>)") + model), "");
  EXPECT_EQ(Check(Tree("A", R"(<Action ID="IsDark" limt="3"/>)") + model),
            "t.xml:2:22: warning: \"IsDark\" is written as <Action> (it is a Condition)\n"
            R"(t.xml:2:42: warning: the model of IsDark has no port "limt" )"
            "(did you mean \"limit\"?)\n");
  EXPECT_EQ(Check(Tree("A", "<IsDark><AlwaysSuccess/></IsDark>") + model),
            "t.xml:2:22: warning: IsDark has 1 child, expected none "
            "(its model says that it is a Condition)\n");
}

TEST(CheckProject, AModelThatContradictsABuiltInNodeCounts) {
  const std::string model =
      R"(<TreeNodesModel><Condition ID="Cooldown"><input_port name="motor"/></Condition>)"
      "</TreeNodesModel>";
  EXPECT_EQ(
      Check(Tree("A", R"(<Cooldown motor="left"/>)") + model),
      R"(t.xml:3:17: warning: "Cooldown" of this model is of category Condition, but the built-in )"
      "Decorator of that name is not (trees are checked against the model)\n");
  EXPECT_EQ(
      Check(Tree("A", R"(<Cooldown moter="left"/>)") + model),
      R"(t.xml:3:17: warning: "Cooldown" of this model is of category Condition, but the built-in )"
      "Decorator of that name is not (trees are checked against the model)\n"
      R"(t.xml:2:32: warning: the model of Cooldown has no port "moter" )"
      "(did you mean \"motor\"?)\n");
}

TEST(CheckProject, AModelThatAgreesWithABuiltInNodeChangesNothing) {
  const std::string model =
      R"(<TreeNodesModel><Decorator ID="Cooldown"><input_port name="msec"/></Decorator>)"
      "</TreeNodesModel>";
  EXPECT_EQ(Check(Tree("A", "<Cooldown><AlwaysSuccess/></Cooldown>") + model),
            R"(t.xml:2:22: error: Cooldown needs its port "msec" )"
            "(how long [ms])\n");
}

TEST(CheckProject, TheBuiltInNodeCountsIfAllTypesAreKnown) {
  const std::string model = R"(<TreeNodesModel><Condition ID="Cooldown"/></TreeNodesModel>)";
  EXPECT_EQ(Check(Tree("A", R"(<Cooldown msec="1"/>)") + model, {true}),
            "t.xml:2:22: error: Cooldown has 0 children, expected exactly 1\n");
}

TEST(CheckProject, TellsProgramsWhatAProblemIsAbout) {
  const struct {
    const char* body;
    ProblemKind kind;
    const char* name;
  } cases[] = {
      {"<Say/>", ProblemKind::kNoModel, "Say"},
      {"<Sequense><AlwaysSuccess/></Sequense>", ProblemKind::kOther, ""},  // may be misspelt
      {"<Repeat><AlwaysSuccess/></Repeat>", ProblemKind::kMissingPort, "num_cycles"},
      {R"(<AlwaysSuccess speed="1"/>)", ProblemKind::kUnknownPort, "speed"},
      {"", ProblemKind::kEmptyTree, "A"},
      {"<Script code='n := mim(1, 2)'/>", ProblemKind::kInScript, ""},
      {"<Inverter/>", ProblemKind::kOther, ""},
  };
  for (const auto& c : cases) {
    const Diagnostics found = ProblemsOf(Tree("A", c.body));
    ASSERT_EQ(found.all().size(), 1U) << c.body << "\n" << found.ToString();
    EXPECT_EQ(found.all()[0].about.kind, c.kind) << c.body;
    EXPECT_EQ(found.all()[0].about.name, c.name) << c.body;
  }
}

TEST(CheckProject, TheGuardsOfASubTreeAreCheckedWhereverItsTreeIs) {
  const std::string problems = Check(Tree("A", R"(<SubTree ID="Gone" _skipIf="x :="/>)"));
  EXPECT_NE(problems.find("tree \"Gone\" is not among these files"), std::string::npos) << problems;
  EXPECT_NE(problems.find("error: expected a value after \":=\""), std::string::npos) << problems;
}

}  // namespace
}  // namespace coppice
