#include "editor/scene/node_models.h"

#include <gtest/gtest.h>

#include <optional>

namespace coppice::editor {
namespace {

NodeModels With(const std::string& models) {
  Diagnostics diagnostics;
  const auto document = Document::FromText(
      "<root>\n<TreeNodesModel>" + models + "</TreeNodesModel></root>", "m.xml", diagnostics);
  EXPECT_TRUE(document) << diagnostics.ToString();
  NodeModels all;
  all.AddFrom(*document);
  return all;
}

TEST(NodeModels, KnowTheBuiltInTypes) {
  const NodeModels models;
  ASSERT_NE(models.Find("RetryUntilSuccessful"), nullptr);
  EXPECT_EQ(models.Find("RetryUntilSuccessful")->category, NodeCategory::kDecorator);
  EXPECT_NE(models.Find("RetryUntilSuccessful")->FindPort("num_attempts"), nullptr);
  EXPECT_EQ(models.Find("DriveTo"), nullptr);
}

TEST(NodeModels, SayInWordsWhatEveryTypeFits) {
  EXPECT_EQ(TypeText("BT::AnyTypeAllowed"), "any type");
  EXPECT_EQ(TypeText("Pose2D"), "Pose2D");
}

TEST(NodeModels, ReadPortsInTheDeclaredOrderWithTheirMeaning) {
  const NodeModels models =
      With(R"(<Action ID="Go"><output_port name="z" type="int"/>)"
           R"(<input_port name="a" type="double" default="0.5">limit [m/s] &lt; 1</input_port>)"
           R"(<MetadataFields><Metadata description="Goes there."/></MetadataFields></Action>)");
  const KnownModel* go = models.Find("Go");
  ASSERT_NE(go, nullptr);
  ASSERT_EQ(go->ports.size(), 2U);
  EXPECT_EQ(go->ports[0].direction, PortDirection::kOutput);
  EXPECT_EQ(go->ports[1].default_text, "0.5");
  EXPECT_EQ(go->ports[1].description, "limit [m/s] < 1");
  EXPECT_EQ(go->description, "Goes there.");
  EXPECT_EQ(go->source, "m.xml:2");
}

TEST(NodeModels, ReadDescriptionsAsTheParserOfTheEngineDoes) {
  const NodeModels models = With(
      "<Action ID='Go'><input_port name='a' default='a > b'>after &#65; <![CDATA[<b>]]>"
      "</input_port></Action>");
  const PortModel& port = models.Find("Go")->ports[0];
  EXPECT_EQ(port.default_text, "a > b");
  EXPECT_EQ(port.description, "after A <b>");
}

TEST(NodeModels, DoNotLetAFileChangeABuiltInType) {
  const NodeModels models = With(R"(<Action ID="Sequence"/>)");
  EXPECT_EQ(models.Find("Sequence")->category, NodeCategory::kControl);
}

TEST(NodeModels, SkipModelsWithoutAnIdAndElementsThatAreNone) {
  const std::size_t before = NodeModels().all().size();
  EXPECT_EQ(With(R"(<Action/><Thing ID="X"/>)").all().size(), before);
}

}  // namespace
}  // namespace coppice::editor
