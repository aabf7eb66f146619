#include "bt_core/analysis/formats/full_xml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/analysis/recorded_run.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string XmlOf(const std::string& trees) {
  return FullXml(RecordedRun(trees).keeper.run.trees()[0]);
}

TEST(FullXml, HasATreeForEachInstanceAndNumbersNodesFromOne) {
  const std::string xml = XmlOf(
      "<BehaviorTree ID='Main'><Sequence name='s'><SubTree ID='Sub' name='a' speed='2'/>"
      "<SubTree ID='Sub' name='b' speed='{v}'/></Sequence></BehaviorTree>"
      "<BehaviorTree ID='Sub'><Sleep name='z' msec='5'/></BehaviorTree>");
  EXPECT_THAT(xml, HasSubstr("<BehaviorTree ID=\"Main\" _fullpath=\"\">\n"
                             "    <Sequence name=\"s\" _uid=\"1\">\n"
                             R"(      <SubTree ID="Sub" name="a" speed="2" _uid="2" )"
                             "_fullpath=\"a\"/>\n"));
  EXPECT_THAT(xml, HasSubstr("<BehaviorTree ID=\"Sub\" _fullpath=\"a\">\n"
                             "    <Sleep name=\"z\" msec=\"5\" _uid=\"3\"/>\n"));
  EXPECT_THAT(xml, HasSubstr("<BehaviorTree ID=\"Sub\" _fullpath=\"b\">\n"
                             "    <Sleep name=\"z\" msec=\"5\" _uid=\"5\"/>\n"));
  EXPECT_EQ(xml.rfind("<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\">\n", 0), 0U);
}

TEST(FullXml, IsReadAsXmlWhateverTheTextsAre) {
  const std::string xml = XmlOf(
      "<BehaviorTree ID='Main'><ScriptCondition name='&lt;&quot;&amp;&apos;&gt;' "
      "code='a &lt; 1 &amp;&amp; b' _skipIf='a == &quot;x&quot;' _uid='77'/></BehaviorTree>");
  Diagnostics diagnostics;
  const auto document = Document::FromText(xml, "full.xml", diagnostics);
  ASSERT_TRUE(document) << diagnostics.ToString() << xml;
  const Element& node =
      document->element(document->element(document->element(kRootElement).first_child).first_child);
  EXPECT_EQ(document->AttributeValue(node, "name"), "<\"&'>");
  EXPECT_EQ(document->AttributeValue(node, "code"), "a < 1 && b");
  EXPECT_EQ(document->AttributeValue(node, "_skipIf"), R"(a == "x")");
  EXPECT_EQ(document->AttributeValue(node, "_uid"), "1") << "the number, not what was there";
}

TEST(FullXml, OfADescriptionWithoutDocumentsAndModelsHasTheNodesAlone) {
  TreeDescription tree = RecordedRun(
                             "<BehaviorTree ID='Main'><AlwaysSuccess name='a'/>"
                             "</BehaviorTree>")
                             .keeper.run.trees()[0];
  tree.documents.clear();
  tree.models = "<TreeNodesModel>";
  const std::string xml = FullXml(tree);
  EXPECT_THAT(xml, HasSubstr(R"(<AlwaysSuccess _uid="1"/>)"));
  EXPECT_THAT(xml, Not(HasSubstr("TreeNodesModel")));
}

}  // namespace
}  // namespace coppice
