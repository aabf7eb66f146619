#include "bt_core/engine/compile/compiler_scripts.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

struct ScriptTableTest : testing::Test {
  Diagnostics diagnostics;
  const Project project = *Project::FromText(
      "<root BTCPP_format=\"4\"><BehaviorTree ID=\"M\">\n<Script code=\"a b\" key=\"{k}\"/>"
      "</BehaviorTree></root>",
      "t.xml", diagnostics);
  Problems problems{diagnostics};
  Layout layout;
  KeyTable keys{layout};
  SlotTypes types{layout, problems};
  ScriptTable scripts{keys, types, problems};

  Site TheNode() { return Site(project, 0, ElementIndex{2}, keys.AddScope(kMainScope, false)); }
};

TEST_F(ScriptTableTest, ScriptsAreNumberedInTheOrderOfAdding) {
  const Site site = TheNode();
  EXPECT_EQ(scripts.Add(site, site.begin()[0], ScriptUse::kAction), 0U);
  EXPECT_EQ(scripts.AddDefault(site, "x", ScriptUse::kAction), 1U);
  EXPECT_EQ(diagnostics.ToString(), "");
}

TEST_F(ScriptTableTest, AKeyInBracesIsNoScript) {
  const Site site = TheNode();
  EXPECT_EQ(scripts.Add(site, site.begin()[1], ScriptUse::kAction), kNoScript);
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:2:25: error: a script cannot come from the blackboard: \"{k}\" (it is compiled "
            "when the tree is loaded; write the script itself, in which a key stands without "
            "braces)\n");
}

// The tree of the tests below: what is wrong with one script in it.
std::string Problem(const std::string& body) {
  Diagnostics diagnostics;
  CompileText(Main(body), diagnostics, TestRegistry());
  return diagnostics.ToString();
}

TEST(Scripts, AnAssignmentInAConditionIsAWarning) {
  const char* const conditions[] = {"<AlwaysSuccess _skipIf=\"x = 3\"/>",
                                    "<ScriptCondition code=\"x = 3\"/>",
                                    "<Precondition if=\"x = 3\"><AlwaysSuccess/></Precondition>"};
  for (const std::string text : conditions) {
    const std::string column = std::to_string(text.find(" = ") + 2);
    EXPECT_EQ(Problem("<Sequence><Script code=\"x := 1\"/>\n" + text + "</Sequence>"),
              "t.xml:4:" + column +
                  ": warning: this condition assigns to \"x\" (did you mean \"==\"?)\n");
  }
  EXPECT_EQ(Problem("<AlwaysSuccess _onStart=\"x := 3\" _post=\"x = 3\" _onHalted=\"x = 3\"/>"),
            "");
}

TEST(Scripts, AWarningDoesNotHinderTheTree) {
  Stage stage(
      Main("<Sequence><Script code=\"x := 1\"/><ScriptCondition code=\"x = 3\"/></Sequence>"));
  EXPECT_EQ(stage.executor->Tick(), Status::kSuccess);
}

TEST(Scripts, AProblemIsReportedWhereItStandsInTheAttribute) {
  EXPECT_EQ(Problem("<AlwaysSuccess _skipIf=\"a &gt; 1 &amp;&amp; \"/>").substr(0, 17),
            "t.xml:3:45: error");
}

TEST(Scripts, KeysGetTheTypesThatPortsGiveThemAnywhereInTheTree) {
  Diagnostics diagnostics;
  const auto program =
      CompileText(Main("<Sequence><AlwaysSuccess _onStart=\"distance := 1\"/>"
                       "<Drive goal=\"1\" total=\"{t}\" distance=\"{distance}\"/></Sequence>"),
                  diagnostics, TestRegistry());
  ASSERT_TRUE(program) << diagnostics.ToString();
  Blackboard blackboard = MakeBlackboard(program->layout);
  program->scripts[0].Run(blackboard);
  EXPECT_TRUE(blackboard[program->layout.Find(kMainScope, "distance")].value.Is<double>());
}

TEST(Scripts, ANumberIsWrittenToAKeyOfTextsAsItsText) {
  Stage stage(
      Main("<Sequence><Script code=\"k := 3\"/><Tell text=\"{k}\" to=\"{told}\"/>"
           "<ScriptCondition code=\"k == 3\"/></Sequence>"));
  EXPECT_EQ(stage.executor->Tick(), Status::kSuccess);
  const SlotIndex told = stage.program->layout.Find(kMainScope, "told");
  EXPECT_EQ(stage.executor->blackboard()[told].value.Get<std::string>(), "3");
}

TEST(Scripts, NamesResolveLikeKeysThroughRemapping) {
  Diagnostics diagnostics;
  const auto program = CompileText(
      Root("<BehaviorTree ID=\"Main\"><SubTree ID=\"S\" inside=\"{outside}\"/></BehaviorTree>"
           "<BehaviorTree ID=\"S\"><AlwaysSuccess _onStart=\"inside := 7; @root := 8; own := 9\"/>"
           "</BehaviorTree>"),
      diagnostics, TestRegistry());
  ASSERT_TRUE(program) << diagnostics.ToString();
  Blackboard blackboard = MakeBlackboard(program->layout);
  program->scripts[0].Run(blackboard);
  const auto text = [&](ScopeIndex scope, const char* key) {
    const SlotIndex slot = program->layout.Find(scope, key);
    return slot == kNoSlot ? "(no key)" : blackboard[slot].value.Print();
  };
  EXPECT_EQ(text(kMainScope, "outside"), "7");
  EXPECT_EQ(text(kMainScope, "root"), "8");
  EXPECT_EQ(text(kMainScope, "own"), "(no key)");
  EXPECT_EQ(text(ScopeIndex{1}, "own"), "9");
}

TEST(Scripts, AGuardOfASubTreeSpeaksOfTheKeysOutside) {
  Diagnostics diagnostics;
  const auto program = CompileText(
      Root("<BehaviorTree ID=\"Main\"><SubTree ID=\"S\" _onStart=\"k := 1\"/></BehaviorTree>"
           "<BehaviorTree ID=\"S\"><AlwaysSuccess/></BehaviorTree>"),
      diagnostics, TestRegistry());
  ASSERT_TRUE(program) << diagnostics.ToString();
  ASSERT_EQ(program->guards.size(), 1U);
  EXPECT_EQ(program->guards[0].node, 0U);
  EXPECT_EQ(program->nodes[0].dispatch, NodeType::kGuarded);
  EXPECT_EQ(program->nodes[0].type, NodeType::kSubTree);
  EXPECT_NE(program->layout.Find(kMainScope, "k"), kNoSlot);
}

}  // namespace
}  // namespace coppice
