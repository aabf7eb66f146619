// SubTrees: scopes, remapping, literals, limits.
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

std::string Tree(const std::string& id, const std::string& body) {
  return "<BehaviorTree ID=\"" + id + "\">" + body + "</BehaviorTree>\n";
}

std::string Problems(const std::string& trees) {
  Diagnostics diagnostics;
  CompileText(Root(trees), diagnostics, TestRegistry());
  return diagnostics.ToString();
}

// Value of a key of the main tree after one tick, or "(unset)".
std::string After(const std::string& trees, const std::string& key) {
  Stage stage(Root(trees));
  stage.executor->Tick();
  const SlotIndex slot = stage.program->layout.Find(kMainScope, key);
  if (slot == kNoSlot) return "(no key)";
  const Value& value = stage.executor->blackboard()[slot].value;
  return value.has_value() ? value.Print() : "(unset)";
}

TEST(SubTree, IsExpandedInPlace) {
  Stage stage(Root(Tree("Main", "<Sequence><SubTree ID=\"S\"/><AlwaysSuccess/></Sequence>") +
                   Tree("S", "<Inverter><AlwaysFailure/></Inverter>")));
  const auto& nodes = stage.program->nodes;
  ASSERT_EQ(nodes.size(), 5U);
  EXPECT_EQ(nodes[1].type, NodeType::kSubTree);
  EXPECT_EQ(nodes[1].end, 4U);
  EXPECT_EQ(nodes[2].type, NodeType::kInverter);
  ASSERT_EQ(stage.program->trees.size(), 2U);
  EXPECT_EQ(stage.program->trees[1].id, "S");
  EXPECT_EQ(stage.program->trees[1].root, 2U);
  EXPECT_EQ(stage.program->trees[1].node, 1U);
}

TEST(SubTree, NeedsANameOfItsOwn) {
  const std::string problems = Problems(
      Tree("Main",
           "<Sequence><SubTree ID=\"S\" name=\"a\"/><SubTree ID=\"S\" name=\"a\"/></Sequence>") +
      Tree("S", "<AlwaysSuccess/>"));
  EXPECT_NE(problems.find("two SubTrees in the same tree have the name \"a\""), std::string::npos)
      << problems;
}

TEST(SubTree, HasAScopeOfItsOwn) {
  EXPECT_EQ(After(Tree("Main",
                       "<Sequence><Tell text=\"outer\" to=\"{k}\"/><SubTree ID=\"S\"/>"
                       "</Sequence>") +
                      Tree("S", "<Tell text=\"inner\" to=\"{k}\"/>"),
                  "k"),
            "outer");
}

TEST(SubTree, ARemappedKeyIsTheSameSlot) {
  EXPECT_EQ(After(Tree("Main", "<SubTree ID=\"S\" result=\"{answer}\"/>") +
                      Tree("S", "<Tell text=\"42\" to=\"{result}\"/>"),
                  "answer"),
            "42");
}

TEST(SubTree, EqualsSignRemapsToTheSameName) {
  for (const char* text : {"=", "{=}"}) {
    EXPECT_EQ(After(Tree("Main", std::string("<SubTree ID=\"S\" k=\"") + text + "\"/>") +
                        Tree("S", "<Tell text=\"x\" to=\"{k}\"/>"),
                    "k"),
              "x");
  }
}

TEST(SubTree, RemappingGoesThroughLevels) {
  EXPECT_EQ(After(Tree("Main", "<SubTree ID=\"A\" x=\"{top}\"/>") +
                      Tree("A", "<SubTree ID=\"B\" y=\"{x}\"/>") +
                      Tree("B", "<Tell text=\"deep\" to=\"{y}\"/>"),
                  "top"),
            "deep");
}

TEST(SubTree, AutoremapSharesAllKeysButPrivateOnes) {
  const std::string trees = Tree("Main",
                                 "<Sequence><SubTree ID=\"S\" _autoremap=\"true\"/>"
                                 "<Tell text=\"x\" to=\"{other}\"/></Sequence>") +
                            Tree("S",
                                 "<Sequence><Tell text=\"1\" to=\"{shared}\"/>"
                                 "<Tell text=\"2\" to=\"{_own}\"/></Sequence>");
  EXPECT_EQ(After(trees, "shared"), "1");
  EXPECT_EQ(After(trees, "_own"), "(no key)");
}

TEST(SubTree, ExplicitRemappingWinsOverAutoremap) {
  EXPECT_EQ(After(Tree("Main", "<SubTree ID=\"S\" _autoremap=\"true\" k=\"{other}\"/>") +
                      Tree("S", "<Tell text=\"1\" to=\"{k}\"/>"),
                  "other"),
            "1");
}

TEST(SubTree, AtSignReachesTheMainTree) {
  EXPECT_EQ(After(Tree("Main", "<SubTree ID=\"A\"/>") + Tree("A", "<SubTree ID=\"B\"/>") +
                      Tree("B", "<Tell text=\"global\" to=\"{@k}\"/>"),
                  "k"),
            "global");
}

TEST(SubTree, ALiteralGetsTheTypeOfThePortInside) {
  EXPECT_EQ(After(Tree("Main", "<SubTree ID=\"S\" v=\"00042\" out=\"{r}\"/>") +
                      Tree("S", "<Tell text=\"{v}\" to=\"{out}\"/>"),
                  "r"),
            "00042");
  EXPECT_EQ(After(Tree("Main", "<SubTree ID=\"S\" v=\"00042\" out=\"{r}\"/>") +
                      Tree("S", "<Drive goal=\"{v}\" total=\"{t}\" distance=\"{out}\"/>"),
                  "r"),
            "84");
}

TEST(SubTree, AWrongLiteralIsReportedWhereItIsWritten) {
  EXPECT_EQ(Problems(Tree("Main", "<SubTree ID=\"S\" v=\"far\"/>") +
                     Tree("S", "<Drive goal=\"{v}\" total=\"{t}\"/>")),
            "t.xml:2:44: error: \"far\" is not a value for key \"v\" inside (expected double)\n");
}

TEST(SubTree, TypesMustAgreeAcrossTheBoundary) {
  EXPECT_EQ(Problems(Tree("Main",
                          "<Sequence><Tell text=\"x\" to=\"{k}\"/>"
                          "<SubTree ID=\"S\" v=\"{k}\"/></Sequence>") +
                     Tree("S", "<Drive goal=\"{v}\" total=\"{t}\"/>")),
            "t.xml:3:35: error: key \"k\" is string (from Tell.to), but port \"goal\" of Drive is "
            "double\n");
}

TEST(SubTree, UnknownTreeGetsTheNearestName) {
  EXPECT_EQ(Problems(Tree("Main", "<SubTree ID=\"Dokc\"/>") + Tree("Dock", "<AlwaysSuccess/>")),
            "t.xml:2:25: error: no tree \"Dokc\" (did you mean \"Dock\"?)\n");
}

TEST(SubTree, NeedsAnId) {
  EXPECT_EQ(Problems(Tree("Main", "<SubTree/>")), "t.xml:2:25: error: <SubTree> without ID\n");
}

TEST(SubTree, MustNotHaveChildren) {
  EXPECT_EQ(Problems(Tree("Main", "<SubTree ID=\"S\"><AlwaysSuccess/></SubTree>") +
                     Tree("S", "<AlwaysSuccess/>")),
            "t.xml:2:25: error: <SubTree> must not have children\n");
}

TEST(SubTree, MustNotContainItself) {
  EXPECT_EQ(Problems(Tree("Main", "<SubTree ID=\"A\"/>") + Tree("A", "<SubTree ID=\"B\"/>") +
                     Tree("B", "<SubTree ID=\"A\"/>")),
            "t.xml:4:22: error: tree \"A\" contains itself (A -> B -> A)\n");
}

TEST(SubTree, DoublingIsStoppedBeforeMemoryIsUsedUp) {
  std::string trees = Tree("Main", "<SubTree ID=\"T0\"/>");
  for (int i = 0; i < 40; ++i) {
    const std::string next = "<SubTree ID=\"T" + std::to_string(i + 1) + "\"/>";
    trees += Tree("T" + std::to_string(i), "<Sequence>" + next + next + "</Sequence>");
  }
  trees += Tree("T40", "<AlwaysSuccess/>");
  const std::string problems = Problems(trees);
  EXPECT_NE(
      problems.find("error: the long paths of the nodes and their ports take more than 32 MiB"),
      std::string::npos)
      << problems.substr(0, 300);
}

// In a record each node has its path, and each literal that of its node.
TEST(SubTree, ALongPathIsNotGivenToThousandsOfNodes) {
  const std::string name(100'000, 'n');
  std::string nodes;
  for (int i = 0; i < 200; ++i) nodes += "<Sleep msec=\"" + std::to_string(i) + "\"/>";
  const std::string problems = Problems(Tree("Main", "<SubTree ID=\"T\" name=\"" + name + "\"/>") +
                                        Tree("T", "<Sequence>" + nodes + "</Sequence>"));
  EXPECT_NE(problems.find("long paths of the nodes and their ports take more than 32 MiB"),
            std::string::npos)
      << problems.substr(0, 300);
}

TEST(SubTree, PathsOfUsualLengthHaveABoundTogether) {
  const auto calls = [](const char* id, const std::string& begin) {
    std::string text = "<Sequence>";
    for (int i = 0; i < 700; ++i) {
      text +=
          std::string("<SubTree ID=\"") + id + "\" name=\"" + begin + std::to_string(i) + "\"/>";
    }
    return text + "</Sequence>";
  };
  const std::string problems =
      Problems(Tree("Main", calls("T1", "")) + Tree("T1", calls("T2", std::string(70, 'n'))) +
               Tree("T2", "<AlwaysSuccess/>"));
  EXPECT_NE(problems.find("error: the paths of the SubTrees take more than 32 MiB"),
            std::string::npos)
      << problems.substr(0, 300);
}

TEST(SubTree, AMillionNodesAreTheMost) {
  std::string trees = Tree("Main", "<SubTree ID=\"T0\"/>");
  for (int i = 0; i < 4; ++i) {
    std::string body;
    for (int k = 0; k < 40; ++k) body += "<SubTree ID=\"T" + std::to_string(i + 1) + "\"/>";
    trees += Tree("T" + std::to_string(i), "<Sequence>" + body + "</Sequence>");
  }
  trees += Tree("T4", "<AlwaysSuccess/>");
  EXPECT_EQ(
      Problems(trees),
      "t.xml:6:357: error: the tree has more than 1000000 nodes (counted with all SubTrees)\n");
}

TEST(SubTree, KeysScriptsAndRemappingsHaveABoundTogether) {
  std::string keys, scripts, remaps, calls;
  for (int i = 0; i < 900; ++i) {
    const std::string key = "k" + std::to_string(i);
    keys += "<SetBlackboard value=\"1\" output_key=\"" + key + "\"/>";
    scripts += "<Script code=\"" + key + " := 1\"/>";
    remaps += " " + key + "=\"{" + key + "}\"";
  }
  for (int i = 0; i < 900; ++i) calls += "<SubTree ID=\"T\"/>";
  const std::string main = Tree("Main", "<Sequence>" + calls + "</Sequence>");
  const std::string call = "<Sequence><SubTree ID=\"U\"" + remaps + "/><SubTree ID=\"U\"" + remaps +
                           "/><SubTree ID=\"U\"" + remaps + "/></Sequence>";
  for (const std::string& body :
       {"<Sequence>" + keys + "</Sequence>", "<Sequence>" + scripts + "</Sequence>", call}) {
    const std::string problems = Problems(main + Tree("T", body) + Tree("U", "<AlwaysSuccess/>"));
    EXPECT_NE(problems.find("error: the keys, values and scripts take more than 128 MiB"),
              std::string::npos)
        << problems.substr(0, 300);
  }
}

// Trees of 50 nodes each in one line, one inside the other.
std::string DeepTrees(int count) {
  std::string trees;
  for (int i = 0; i < count; ++i) {
    std::string body = i + 1 < count ? "<SubTree ID=\"T" + std::to_string(i + 1) + "\"/>"
                                     : std::string("<AlwaysSuccess/>");
    for (int k = 0; k < 49; ++k) body = "<Inverter>" + body + "</Inverter>";
    trees += Tree(i == 0 ? "Main" : "T" + std::to_string(i), body);
  }
  return trees;
}

TEST(SubTree, NodesMayBeNestedTenThousandDeep) {
  Diagnostics diagnostics;
  const auto program = CompileText(Root(DeepTrees(200)), diagnostics, TestRegistry());
  ASSERT_TRUE(program) << diagnostics.ToString();
  EXPECT_EQ(program->nodes.size(), 10'000U);
  EXPECT_EQ(program->nodes[0].end, 10'000U);
  EXPECT_EQ(program->info[9'999].parent, 9'998U);
}

TEST(SubTree, NodesMustNotBeNestedDeeper) {
  const std::string problems = Problems(DeepTrees(201));
  EXPECT_NE(
      problems.find("error: nodes are nested more than 10000 deep (counted with all SubTrees)"),
      std::string::npos)
      << problems;
}

TEST(SubTree, ALongChainIsStoppedBeforeMemoryIsUsedUp) {
  std::string trees = Tree("Main", "<SubTree ID=\"T0\"/>");
  for (int i = 0; i < 50000; ++i) {
    trees += Tree("T" + std::to_string(i), "<SubTree ID=\"T" + std::to_string(i + 1) + "\"/>");
  }
  trees += Tree("T50000", "<AlwaysSuccess/>");
  const std::string problems = Problems(trees);
  EXPECT_NE(
      problems.find("error: the long paths of the nodes and their ports take more than 32 MiB"),
      std::string::npos)
      << problems;
}

TEST(SubTree, FormatThreeDoesNotAskForThePortsOfAModel) {
  const std::string trees =
      Tree("Main", "<SubTree ID=\"S\"/>") + Tree("S", "<AlwaysSuccess/>") +
      "<TreeNodesModel><SubTree ID=\"S\"><input_port name=\"x\"/></SubTree></TreeNodesModel>";
  const auto check = [&trees](const std::string& format) {
    Diagnostics diagnostics;
    const bool runs =
        CompileText("<root" + format + " main_tree_to_execute=\"Main\">" + trees + "</root>",
                    diagnostics, TestRegistry()) != nullptr;
    return (runs ? "runs: " : "no: ") + diagnostics.ToString();
  };
  EXPECT_NE(check(" BTCPP_format=\"4\"").find("no: t.xml:1:76: error: SubTree \"S\" needs"),
            std::string::npos)
      << check(" BTCPP_format=\"4\"");
  EXPECT_NE(
      check(" BTCPP_format=\"3\"").find("warning: SubTree \"S\" needs its port \"x\" in format 4"),
      std::string::npos);
  EXPECT_EQ(check(" BTCPP_format=\"3\"").substr(0, 4), "runs");
}

}  // namespace
}  // namespace coppice
