#include "bt_core/model/upgrade.h"

#include <algorithm>

#include "tests/bt_core/model/edited.h"

namespace coppice {
namespace {

struct Upgraded {
  std::string text;
  std::string problems;
};

Upgraded Upgrade(const std::string& text) {
  const Document document = Parsed(text);
  Diagnostics diagnostics;
  Upgraded upgraded;
  upgraded.text = After(document, UpgradeToFormat4(document, diagnostics));
  upgraded.problems = diagnostics.ToString();
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_FALSE(IsFormat3(Parsed(upgraded.text)));
  return upgraded;
}

std::string Root3(const std::string& tree) {
  return R"(<root BTCPP_format="3"><BehaviorTree ID="M">)" + tree + "</BehaviorTree></root>";
}
std::string Root4(const std::string& tree) {
  return R"(<root BTCPP_format="4"><BehaviorTree ID="M">)" + tree + "</BehaviorTree></root>";
}

// One node of format 3, without problems.
std::string Node(const std::string& node) {
  const Upgraded upgraded = Upgrade(Root3(node));
  EXPECT_EQ(upgraded.problems, "") << node;
  const std::size_t begin = Root4("").find("</Beh");
  return upgraded.text.substr(begin, upgraded.text.size() - Root4("").size());
}

TEST(Upgrade, KeepsEverythingElseAsItIs) {
  const std::string text =
      "\xEF\xBB\xBF<?xml version='1.0'?>\r\n<!-- SequenceStar -->\r\n"
      "<root  main_tree_to_execute = 'M' >\r\n"
      "\t<BehaviorTree ID='M'>\r\n"
      "\t\t<SequenceStar name='s'> <!-- the star -->\r\n"
      "\t\t\t<SubTree ID='T' goal = 'target'/>\r\n"
      "\t\t</SequenceStar >\r\n"
      "\t</BehaviorTree>\r\n"
      "\t<TreeNodesModel><Control ID='SequenceStar'/></TreeNodesModel>\r\n"
      "</root>\r\n";
  std::string expected = text;
  const auto replace = [&expected](const std::string& what, const std::string& by) {
    expected.replace(expected.find(what), what.size(), by);
  };
  replace("= 'M' >", "= 'M' BTCPP_format='4' >");
  replace("<SequenceStar name", "<SequenceWithMemory name");
  replace("</SequenceStar >", "</SequenceWithMemory >");
  replace("'target'", "'{target}'");
  const Upgraded upgraded = Upgrade(text);
  EXPECT_EQ(upgraded.text, expected);
  EXPECT_EQ(upgraded.problems, "");
}

TEST(Upgrade, RenamesNodes) {
  EXPECT_EQ(Node("<SequenceStar><A/></SequenceStar>"),
            "<SequenceWithMemory><A/></SequenceWithMemory>");
  EXPECT_EQ(Node("<FallbackStar/>"), "<Fallback/>");
  EXPECT_EQ(Node("<RetryUntilSuccesful num_attempts='2'/>"),
            "<RetryUntilSuccessful num_attempts='2'/>");
  EXPECT_EQ(Node("<Control ID='SequenceStar'><SequenceStar/></Control>"),
            "<Control ID='SequenceWithMemory'><SequenceWithMemory/></Control>");
  EXPECT_EQ(Node("<Decorator ID='RetryUntilSuccesful'/>"),
            "<Decorator ID='RetryUntilSuccessful'/>");
  EXPECT_EQ(Node("<Action ID='Go' to='SequenceStar'/>"), "<Action ID='Go' to='SequenceStar'/>");
}

TEST(Upgrade, AttributesOfASubTreeAreKeys) {
  EXPECT_EQ(Node("<SubTree ID='T' name='t' a='key' b='{key}' _description='d'/>"),
            "<SubTree ID='T' name='t' a='{key}' b='{key}' _description='d'/>");
}

TEST(Upgrade, WhatCannotBeAKeyIsLeftWithAWarning) {
  const Upgraded upgraded = Upgrade(Root3("<SubTree ID='T' a='0.5'/>"));
  EXPECT_EQ(upgraded.text, Root4("<SubTree ID='T' a='0.5'/>"));
  EXPECT_EQ(upgraded.problems,
            R"(t.xml:1:64: warning: "0.5" is no name for a key; it is left as a value )"
            "(in format 3, the attributes of a SubTree name keys)\n");
}

TEST(Upgrade, SharedBlackboardsBecomeRemapping) {
  EXPECT_EQ(Node("<SubTree ID='T' __shared_blackboard='true'/>"),
            "<SubTree ID='T' _autoremap='true'/>");
  EXPECT_EQ(Node("<SubTree ID='T' __shared_blackboard='false' a='b'/>"),
            "<SubTree ID='T' a='{b}'/>");
}

TEST(Upgrade, SubTreePlusIsTheSubTreeOfFormat4) {
  EXPECT_EQ(Node("<SubTreePlus ID='T' __autoremap='1' a='value' b='{key}'></SubTreePlus>"),
            "<SubTree ID='T' _autoremap='1' a='value' b='{key}'></SubTree>");
}

TEST(Upgrade, ThereIsOneAutoremapAtMost) {
  EXPECT_EQ(Node("<SubTreePlus ID='T' __autoremap='0' __shared_blackboard='1'/>"),
            "<SubTree ID='T' _autoremap='1'/>");
  EXPECT_EQ(Node("<SubTreePlus ID='T' __autoremap='1' __shared_blackboard='0'/>"),
            "<SubTree ID='T' _autoremap='1'/>");
  EXPECT_EQ(Node("<SubTreePlus ID='T' _autoremap='0' __autoremap='1'/>"),
            "<SubTree ID='T' _autoremap='0'/>");
}

TEST(Upgrade, ThresholdsAreCounts) {
  EXPECT_EQ(Node("<Parallel threshold='2'/>"), "<Parallel success_count='2'/>");
  EXPECT_EQ(Node("<Parallel success_threshold='2' failure_threshold='3'/>"),
            "<Parallel success_count='2' failure_count='3'/>");
  EXPECT_EQ(Node("<Parallel threshold='1' success_threshold='2'/>"),
            "<Parallel threshold='1' success_count='2'/>");
}

TEST(Upgrade, ARootAroundTheTreeGoes) {
  EXPECT_EQ(Node("<Root><A/></Root>"), "<A/>");
  EXPECT_EQ(Node("\n  <Root>\n    <!-- c -->\n    <SequenceStar/>\n  </Root>\n"),
            "\n    <!-- c -->\n    <SequenceWithMemory/>\n");
}

TEST(Upgrade, PortsThatHaveBecomeGuardsAreAWarning) {
  EXPECT_NE(Upgrade(Root3("<A _while='x'/>"))
                .problems.find("t.xml:1:48: warning: in format 4, _while is a guard with a script"),
            std::string::npos);
}

TEST(Upgrade, AppliedTwiceChangesNothingMore) {
  const std::string once = Upgrade(Root3("<SubTree ID='T' a='b'/>")).text;
  Diagnostics diagnostics;
  EXPECT_TRUE(UpgradeToFormat4(Parsed(once), diagnostics).empty());
}

bool Is3(const std::string& root_attributes, const std::string& tree) {
  return IsFormat3(
      Parsed("<root " + root_attributes + "><BehaviorTree>" + tree + "</BehaviorTree></root>"));
}

TEST(Format, IsWhatTheFileSays) {
  EXPECT_TRUE(Is3("BTCPP_format='3'", "<Script/>"));
  EXPECT_FALSE(Is3("BTCPP_format='4'", "<SequenceStar/>"));
  EXPECT_FALSE(Is3("BTCPP_format='9'", "<SequenceStar/>"));
}

TEST(Format, IsToldByWhatAFileUsesThatDoesNotSay) {
  EXPECT_TRUE(Is3("", "<A/>"));
  EXPECT_TRUE(Is3("", "<SubTree ID='T' a='b'/>"));
  EXPECT_FALSE(Is3("", "<SubTree ID='T' a='{b}'/>"));
  EXPECT_FALSE(Is3("", "<A _skipIf='x'/>"));
  EXPECT_FALSE(Is3("", "<Control ID='SequenceWithMemory'/>"));
  EXPECT_FALSE(Is3("", "<SubTree ID='T' _autoremap='true'/>"));
  EXPECT_TRUE(Is3("", "<Script/><SubTreePlus ID='T'/>")) << "then the script is a leaf's name";
  EXPECT_TRUE(Is3("", "<Script/><SubTree ID='T' __shared_blackboard='true'/>"));
}

TEST(Upgrade, ManyOfThemAreOneWarning) {
  EXPECT_EQ(
      Upgrade(Root3("<S><SubTree ID='T' a='0.5' b='1'/><SubTree ID='T' a='2'/></S>")).problems,
      R"(t.xml:1:67: warning: "0.5" is no name for a key; it is left as a value )"
      "(in format 3, the attributes of a SubTree name keys; 2 more in this file)\n");
}

// A file of format 3 with a tree B and the models; the tree M as it is upgraded.
std::string WithModels(const std::string& node, const std::string& models) {
  const std::string rest = "<BehaviorTree ID='B'><A/></BehaviorTree><TreeNodesModel>" + models +
                           "</TreeNodesModel></root>";
  const std::string begin = R"(<root BTCPP_format="3"><BehaviorTree ID="M">)";
  const Upgraded upgraded = Upgrade(begin + node + "</BehaviorTree>" + rest);
  EXPECT_EQ(upgraded.problems, "");
  const std::size_t length = upgraded.text.find("</BehaviorTree>") - begin.size();
  return upgraded.text.substr(begin.size(), length);
}

TEST(Upgrade, ATreeThatIsUsedAsANodeTypeBecomesASubTree) {
  EXPECT_EQ(WithModels("<B/>", ""), "<SubTree ID=\"B\"/>");
  EXPECT_EQ(WithModels("<B name='b' __shared_blackboard='true' x='key'></B>", ""),
            "<SubTree name='b' _autoremap='true' x='{key}' ID='B'></SubTree>");
  EXPECT_EQ(WithModels("<B/>", "<Action ID='B'/>"), "<B/>") << "a leaf of that name";
}

TEST(Upgrade, OutputsThatAModelNamesAreKeys) {
  const std::string model =
      "<Action ID='Read'><output_port name='to'/><input_port name='from'/></Action>";
  EXPECT_EQ(WithModels("<Read to='key' from='text'/>", model), "<Read to='{key}' from='text'/>");
  EXPECT_EQ(WithModels("<Action ID='Read' to='1'/>", model), "<Action ID='Read' to='{1}'/>");
  for (const char* same : {"<Read to='{key}'/>", "<Read to=''/>", "<Read to='='/>"}) {
    EXPECT_EQ(WithModels(same, model), same);
  }
}

TEST(Upgrade, ModelsOfSubTreesLoseWhatIsNoPort) {
  const std::string models =
      "<TreeNodesModel>\n<SubTree ID='T'>\n"
      "<inout_port name='__shared_blackboard'/>\n<input_port name='x'/>\n"
      "<input_port name='__autoremap'/>\n</SubTree>\n</TreeNodesModel>";
  const std::string begin = R"(<root BTCPP_format="3">)";
  const Upgraded upgraded = Upgrade(begin + models + "</root>");
  EXPECT_EQ(upgraded.text,
            "<root BTCPP_format=\"4\"><TreeNodesModel>\n<SubTree ID='T'>\n"
            "<input_port name='x'/>\n</SubTree>\n</TreeNodesModel></root>");
}

TEST(Upgrade, TellsNewNames) {
  EXPECT_EQ(NodeNameInFormat4("SequenceStar"), "SequenceWithMemory");
  EXPECT_EQ(NodeNameInFormat4("Sequence"), "");
  EXPECT_EQ(PortNameInFormat4("Parallel", "success_threshold"), "success_count");
  EXPECT_EQ(PortNameInFormat4("Sequence", "success_threshold"), "");
}

}  // namespace
}  // namespace coppice
