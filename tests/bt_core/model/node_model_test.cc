#include "bt_core/model/node_model.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace coppice {
namespace {

std::vector<NodeModel> Read(const std::string& models, Diagnostics& diagnostics) {
  const auto document = Document::FromText("<TreeNodesModel>\n" + models + "\n</TreeNodesModel>",
                                           "m.xml", diagnostics);
  return ReadModels(*document, document->element(kRootElement), 7, diagnostics);
}

std::vector<NodeModel> ReadGood(const std::string& models) {
  Diagnostics diagnostics;
  std::vector<NodeModel> read = Read(models, diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
  return read;
}

TEST(NodeModel, ReadsEverythingThatAModelSays) {
  const auto models = ReadGood(
      "<Action ID='Say'>\n"
      "  <input_port name='text' type='std::string' default='{words}'> what &amp; how "
      "</input_port>\n"
      "  <output_port name='heard'/>\n"
      "  <inout_port name='count' type='int' default='1'/>\n"
      "  <MetadataFields><Metadata subcategory='speech'/><Metadata description='Speaks.'/>"
      "</MetadataFields>\n"
      "</Action><SubTree ID='Dock'/>");
  ASSERT_EQ(models.size(), 2U);
  const NodeModel& say = models[0];
  EXPECT_EQ(say.id, "Say");
  EXPECT_EQ(say.category, NodeCategory::kAction);
  EXPECT_EQ(say.document, 7U);
  EXPECT_EQ(say.element, 1U);
  EXPECT_EQ(say.description, "Speaks.");
  EXPECT_EQ(say.metadata.front(), std::pair(std::string("subcategory"), std::string("speech")));
  ASSERT_EQ(say.ports.size(), 3U);
  EXPECT_EQ(say.ports[0].type, "std::string");
  EXPECT_EQ(say.ports[0].default_text, "{words}");
  EXPECT_EQ(say.ports[0].description, "what & how");
  EXPECT_EQ(say.ports[1].direction, PortDirection::kOutput);
  EXPECT_EQ(say.ports[1].default_text, std::nullopt);
  EXPECT_EQ(say.FindPort("count")->direction, PortDirection::kInOut);
  EXPECT_EQ(say.FindPort("no"), nullptr);
  EXPECT_EQ(models[1].category, NodeCategory::kSubTree);
}

TEST(NodeModel, ADescriptionMayBeAnElement) {
  EXPECT_EQ(ReadGood("<Action ID='A'><description>Does it.</description></Action>")[0].description,
            "Does it.");
}

TEST(NodeModel, WhatIsNoModelIsAWarning) {
  Diagnostics diagnostics;
  const auto models = Read(
      "<Acton ID='A'/>\n<Action/>\n<Action ID='B'><input name='x'/><input_port/>"
      "<input_port name='y'/><output_port name='y'/></Action>",
      diagnostics);
  ASSERT_EQ(models.size(), 1U);
  EXPECT_EQ(models[0].ports.size(), 1U);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.ToString(),
            "m.xml:2:1: warning: <Acton> in <TreeNodesModel> is ignored "
            "(did you mean \"Action\"?)\n"
            "m.xml:3:1: warning: model <Action> without ID is ignored\n"
            "m.xml:4:16: warning: <input> in the model of \"B\" is ignored\n"
            "m.xml:4:33: warning: port without name in the model of \"B\" is ignored\n"
            "m.xml:4:68: warning: second port \"y\" in the model of \"B\" is ignored\n");
}

TEST(NodeModel, InterfacesAreComparedWithoutDescriptions) {
  const auto models = ReadGood(
      "<Action ID='A'><input_port name='x'>one</input_port><input_port name='y'/></Action>"
      "<Action ID='B'><input_port name='y'/><input_port name='x'>two</input_port></Action>"
      "<Action ID='C'><input_port name='x'/><output_port name='y'/></Action>"
      "<Condition ID='D'><input_port name='x'/><input_port name='y'/></Condition>"
      "<Action ID='E'><input_port name='x'/></Action>");
  EXPECT_TRUE(HasSameInterface(models[0], models[1]));
  for (std::size_t i = 2; i < models.size(); ++i) {
    EXPECT_FALSE(HasSameInterface(models[0], models[i])) << models[i].id;
  }
}

}  // namespace
}  // namespace coppice
