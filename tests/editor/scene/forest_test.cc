#include "editor/scene/forest.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/editor/driver.h"
#include "tests/editor/read_forest.h"
#include "tests/support/folders.h"

namespace coppice::editor {
namespace {

TEST(Forest, HoldsTheTreesOfAFileAndItsIncludes) {
  Diagnostics diagnostics;
  const Forest forest =
      Forest::FromFile(SourceFolder() + "/trees/application/patrol.xml", diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.ToString();
  EXPECT_GT(forest.documents().size(), 1U);
  EXPECT_GE(forest.Find("PatrolRound"), 0);
  EXPECT_EQ(forest.trees()[static_cast<std::size_t>(forest.main_tree())].id, "Application");
}

TEST(Forest, ShowsWhatCanBeReadOfAWrongFile) {
  const TemporaryFile file("wrong.xml",
                           R"(<root BTCPP_format="4"><include path="missing.xml"/>)"
                           R"(<BehaviorTree ID="A"><AlwaysSuccess/></BehaviorTree></root>)");
  Diagnostics diagnostics;
  const Forest forest = Forest::FromFile(file.path(), diagnostics);
  EXPECT_TRUE(diagnostics.has_errors());
  EXPECT_EQ(forest.trees().size(), 1U);
  EXPECT_TRUE(forest.project()->has_errors());
}

TEST(Forest, IsEmptyWhenTheFileIsMalformedOrMissing) {
  const TemporaryFile file("broken.xml", "<root>\n  <BehaviorTree");
  Diagnostics diagnostics;
  EXPECT_TRUE(Forest::FromFile(file.path(), diagnostics).trees().empty());
  ASSERT_TRUE(diagnostics.has_errors());
  EXPECT_GT(diagnostics.all()[0].where.line, 0U);
  EXPECT_EQ(Forest::FromFile("/nowhere.xml", diagnostics).main_tree(), -1);
}

TEST(Forest, NamesTheTagsOfItsNodesOnce) {
  const Forest forest = ReadForest(
      R"(<root><BehaviorTree ID="M"><Sequence><A/><A/><B/><A/><Action ID="C"/></Sequence>)"
      R"(</BehaviorTree><TreeNodesModel><Action ID="D"><input_port name="p"/></Action>)"
      R"(<Condition ID="E"/></TreeNodesModel></root>)");
  const std::vector<std::string_view> tags = forest.used_tags();
  for (const std::string_view used : {"Sequence", "A", "B", "Action"}) {
    EXPECT_EQ(std::count(tags.begin(), tags.end(), used), 1) << used;
  }
  for (const std::string_view model : {"Condition", "input_port"}) {
    EXPECT_EQ(std::count(tags.begin(), tags.end(), model), 0) << model;
  }
}

TEST(Forest, FindsTheInstanceOfASubTreeByItsPath) {
  const Forest forest =
      ReadForest(R"(<root><BehaviorTree ID="M" _fullpath=""><Sequence>)"
                 R"(<SubTree ID="S" _fullpath="a"/><SubTree ID="S" _fullpath="b"/></Sequence>)"
                 R"(</BehaviorTree><BehaviorTree ID="S" _fullpath="a"><A/></BehaviorTree>)"
                 R"(<BehaviorTree ID="S" _fullpath="b"><A/></BehaviorTree></root>)");
  const Document& document = *forest.documents()[0];
  std::vector<int> found;
  for (const Element& element : document.elements()) {
    if (element.tag == "SubTree") found.push_back(forest.Resolve(document, element));
  }
  EXPECT_EQ(found, (std::vector<int>{1, 2}));
}

}  // namespace
}  // namespace coppice::editor
