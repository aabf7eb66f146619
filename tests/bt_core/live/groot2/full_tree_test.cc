#include "bt_core/live/groot2/full_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/bt_core/live/watched_tree.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;

std::optional<Document> Parse(const std::string& xml) {
  Diagnostics diagnostics;
  auto document = Document::FromText(xml, "live", diagnostics);
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.ToString();
  return document;
}

std::map<std::string, std::string> Attributes(const Document& document, const Element& element) {
  std::map<std::string, std::string> attributes;
  for (const Attribute* a = document.attributes_begin(element);
       a != document.attributes_end(element); ++a) {
    attributes[std::string(a->name)] = std::string(a->value);
  }
  return attributes;
}

TEST(FullTree, IsXmlThatReadsBack) {
  const auto program = WatchedProgram();
  const auto document = Parse(*WriteFullTree(*program));
  ASSERT_TRUE(document);
  std::vector<std::string> trees;
  std::set<std::string> uids;
  for (const Element& element : document->elements()) {
    auto attributes = Attributes(*document, element);
    if (element.tag == "BehaviorTree")
      trees.push_back(attributes["ID"] + "@" + attributes["_fullpath"]);
    if (attributes.count("_uid")) uids.insert(attributes["_uid"]);
  }
  EXPECT_THAT(trees, ElementsAre("Main@", "Inner@inner"));
  EXPECT_EQ(uids.size(), program->nodes.size());
}

TEST(FullTree, WritesANodeWithNumberNameAndPorts) {
  const auto document = Parse(*WriteFullTree(*WatchedProgram()));
  for (const Element& element : document->elements()) {
    const auto attributes = Attributes(*document, element);
    if (element.tag == "ReactiveSequence") {
      EXPECT_EQ(attributes.at("name"), "top & first");
      EXPECT_EQ(attributes.at("_uid"), "1");
    } else if (element.tag == "SubTree" && attributes.count("_uid")) {
      EXPECT_EQ(attributes, (std::map<std::string, std::string>{{"ID", "Inner"},
                                                                {"_fullpath", "inner"},
                                                                {"_uid", "4"},
                                                                {"literal", "7"},
                                                                {"said", "{text}"}}));
      EXPECT_EQ(element.child_count, 0u);
    } else if (element.tag == "Alternate") {
      EXPECT_EQ(attributes.at("name"), "Alternate");
      EXPECT_EQ(attributes.at("word"), "{said}");
    }
  }
}

TEST(FullTree, EndsWithTheModelsOfAllNodes) {
  const auto program = WatchedProgram();
  const auto document = Parse(*WriteFullTree(*program));
  std::set<std::string> models;
  for (const Element& element : document->elements()) {
    if (element.parent == kNoElement) continue;
    if (document->element(element.parent).tag != "TreeNodesModel") continue;
    models.insert(std::string(document->AttributeValue(element, "ID")));
  }
  EXPECT_EQ(models.size(), program->registry->entries().size());
  EXPECT_EQ(models.count("Fill"), 1u);
}

TEST(FullTree, ListsNodesInstanceByInstance) {
  EXPECT_THAT(NodesByInstance(*WatchedProgram()), ElementsAre(0, 1, 2, 3, 5, 4));
}

TEST(FullTree, IsNothingWhereItWouldBeTooLong) {
  const auto tree = [](std::size_t copies) {
    std::string text = R"(<root BTCPP_format="4" main_tree_to_execute="A">
      <BehaviorTree ID="B"><Sleep msec=")" +
                       std::string(20'000, '0') + R"(1"/></BehaviorTree>
      <BehaviorTree ID="A"><Sequence>)";
    for (std::size_t i = 0; i < copies; ++i) text += R"(<SubTree ID="B"/>)";
    return WriteFullTree(*CompileText(text + "</Sequence></BehaviorTree></root>"));
  };
  const auto short_one = tree(100);
  ASSERT_TRUE(short_one);
  EXPECT_GT(short_one->size(), 2'000'000U);
  EXPECT_FALSE(tree(1000));
}

TEST(FullTree, TakesASubTreeAtTheRoot) {
  const auto program = CompileText(R"(<root BTCPP_format="4" main_tree_to_execute="A">
    <BehaviorTree ID="A"><SubTree ID="B"/></BehaviorTree>
    <BehaviorTree ID="B"><AlwaysSuccess/></BehaviorTree></root>)");
  EXPECT_THAT(NodesByInstance(*program), ElementsAre(0, 1));
  EXPECT_THAT(*WriteFullTree(*program),
              ::testing::HasSubstr(R"(<SubTree ID="B" _fullpath="B::1" _uid="1"/>)"));
}

}  // namespace
}  // namespace coppice
