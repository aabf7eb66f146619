#include "editor/document/node_rules.h"

#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

TEST(NodeRules, KnowHowManyChildrenFit) {
  const Document document = Parsed(
      "<root><BehaviorTree ID='M'><Sequence><Inverter><A/></Inverter><Action ID='Far'/><Odd/>"
      "<SubTree ID='T'/><IfThenElse/></Sequence></BehaviorTree>"
      "<TreeNodesModel><Action ID='A'/></TreeNodesModel></root>");
  NodeModels models;
  models.AddFrom(document);
  const NodeRules rules(models);
  const auto why = [&](const char* name, std::uint32_t more) {
    return rules.HasRoom(document, Find(document, name), more).problem();
  };
  EXPECT_EQ(why("Sequence", 100), "");
  EXPECT_EQ(why("Inverter", 1), "Inverter takes one child");
  EXPECT_EQ(why("A", 1), "A takes no children");
  EXPECT_EQ(why("Action", 1), "Far takes no children");
  EXPECT_EQ(why("SubTree", 1), "T takes no children");
  EXPECT_EQ(why("IfThenElse", 4), "IfThenElse takes at most 3 children");
  EXPECT_EQ(why("Odd", 1), "") << "the type is not known";
  EXPECT_EQ(why("BehaviorTree", 1), "a tree has one root node, and this one has it");
}

TEST(NodeRules, KnowTheCategory) {
  const Document document = Parsed(
      "<root><BehaviorTree ID='M'><Sequence><SubTreePlus ID='T'/><Odd/><Condition ID='C'/>"
      "</Sequence></BehaviorTree></root>");
  const NodeModels models;
  const NodeRules rules(models);
  EXPECT_EQ(rules.CategoryOf(document, Find(document, "Sequence")), NodeCategory::kControl);
  EXPECT_EQ(rules.CategoryOf(document, Find(document, "SubTreePlus")), NodeCategory::kSubTree);
  EXPECT_EQ(rules.CategoryOf(document, Find(document, "Condition")), NodeCategory::kCondition);
  EXPECT_EQ(rules.CategoryOf(document, Find(document, "Odd")), std::nullopt);
  EXPECT_FALSE(IsNode(document, Find(document, "BehaviorTree")));
  EXPECT_TRUE(IsNode(document, Find(document, "Odd")));
}

}  // namespace
}  // namespace coppice::editor
