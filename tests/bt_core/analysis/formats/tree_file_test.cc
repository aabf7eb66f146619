#include "bt_core/analysis/formats/tree_file.h"

#include <gtest/gtest.h>

#include "bt_core/model/project.h"

namespace coppice {
namespace {

TreeDescription Of(const std::vector<std::string>& texts) {
  TreeDescription tree;
  tree.main_tree = "Main";
  for (const std::string& text : texts) {
    tree.documents.push_back({"f" + std::to_string(tree.documents.size()) + ".xml", text});
  }
  return tree;
}

// The tree that the file runs, after "error" and its problems if there are any.
std::string Main(const std::string& xml) {
  Diagnostics diagnostics;
  const auto project = Project::FromText(xml, "saved.xml", diagnostics);
  if (!project || diagnostics.has_errors()) return "error " + diagnostics.ToString();
  return project->main_tree();
}

TEST(TreeFile, OfOneFileIsItsText) {
  const std::string text =
      "<?xml version=\"1.0\"?>\n<!-- kept -->\n<root   BTCPP_format='4'>\n"
      "  <BehaviorTree ID=\"Main\"><AlwaysSuccess  /></BehaviorTree>\n</root>\n";
  EXPECT_EQ(TreeFile(Of({text})), text);
}

TEST(TreeFile, OfSeveralFilesHasAllTreesAndNoIncludes) {
  const std::string joined = TreeFile(Of({R"(<root BTCPP_format="4">
  <include path="sub/b.xml"/>
  <BehaviorTree ID="Main">
    <SubTree ID="B"/>
  </BehaviorTree>
</root>
)",
                                          R"(<root BTCPP_format="4">
  <!-- of B -->
  <BehaviorTree ID="B">
    <AlwaysSuccess/>
  </BehaviorTree>
</root>
)"}));
  EXPECT_EQ(joined, R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <SubTree ID="B"/>
  </BehaviorTree>
  <!-- of B -->
  <BehaviorTree ID="B">
    <AlwaysSuccess/>
  </BehaviorTree>
</root>
)");
  EXPECT_EQ(Main(joined), "Main");
}

TEST(TreeFile, WhatStandsBehindTheRootIsNoPlaceForTrees) {
  const std::string joined = TreeFile(Of(
      {R"(<root><BehaviorTree ID="Main"><SubTree ID="B"/></BehaviorTree></root><!-- </root> -->)",
       R"(<root><BehaviorTree ID="B"><AlwaysSuccess/></BehaviorTree></root>)"}));
  EXPECT_EQ(Main(joined), "Main") << joined;
}

TEST(TreeFile, ATreeThatHadNoNameGetsTheOneThatItRanUnder) {
  const std::string joined =
      TreeFile(Of({R"(<root><BehaviorTree><SubTree ID="B"/></BehaviorTree></root>)",
                   R"(<root><BehaviorTree ID="B"><AlwaysSuccess/></BehaviorTree></root>)"}));
  EXPECT_EQ(Main(joined), "Main") << joined;
}

TEST(TreeFile, RunsTheTreeThatRanAlsoIfTheFileNamesAnother) {
  EXPECT_EQ(Main(TreeFile(Of({R"(<root main_tree_to_execute="Other">
<BehaviorTree ID="Other"><AlwaysSuccess/></BehaviorTree>
<BehaviorTree ID="Main"><AlwaysFailure/></BehaviorTree></root>)"}))),
            "Main");
}

TEST(TreeFile, OfARobotOfBehaviorTreeCppHasNoMarksAndEachTreeOnce) {
  EXPECT_EQ(TreeFile(Of({R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main" _fullpath="">
    <Sequence _uid="1"><SubTree ID="B" _uid="2" _fullpath="B::2"/>
      <SubTree ID="B" _uid="3" _fullpath="B::3"/></Sequence>
  </BehaviorTree>
  <BehaviorTree ID="B" _fullpath="B::2">
    <AlwaysSuccess _uid="4"/>
  </BehaviorTree>
  <BehaviorTree ID="B" _fullpath="B::3">
    <AlwaysSuccess _uid="5"/>
  </BehaviorTree>
</root>
)"})),
            R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <Sequence><SubTree ID="B"/>
      <SubTree ID="B"/></Sequence>
  </BehaviorTree>
  <BehaviorTree ID="B">
    <AlwaysSuccess/>
  </BehaviorTree>
</root>
)");
}

TEST(TreeFile, WhatIsNoXmlIsLeftOut) {
  EXPECT_EQ(TreeFile(Of({"<root"})), "");
  EXPECT_EQ(TreeFile(Of({})), "");
}

}  // namespace
}  // namespace coppice
