#include "editor/document/model_edits.h"

#include <gtest/gtest.h>

#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

constexpr char kBare[] = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main"/>
</root>
)";

constexpr char kModels[] = R"(<root BTCPP_format="4">
  <TreeNodesModel>
    <Action ID="Say">
      <input_port name="text" vendor="7"/>
      <MetadataFields><Metadata description="Speaks."/></MetadataFields>
    </Action>
  </TreeNodesModel>
</root>
)";

std::string After(const Document& document, const Edit& edit) {
  Diagnostics problems;
  const auto edited = document.Edited(edit, problems);
  return edited ? edited->text() : problems.ToString();
}

NodeModel Drive() {
  NodeModel model;
  model.id = "Drive";
  model.description = "Goes there.";
  model.ports = {{"to", PortDirection::kInput, "Pose2D", "where <to>", std::nullopt},
                 {"left", PortDirection::kOutput, "double", "", "0"}};
  return model;
}

TEST(ModelEdits, AFileWithoutModelsGetsAPlaceForThem) {
  const Document document = Parsed(kBare);
  EXPECT_EQ(After(document, AddModel(document, Drive())), R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main"/>
  <TreeNodesModel>
    <Action ID="Drive">
      <input_port name="to" type="Pose2D">where &lt;to></input_port>
      <output_port name="left" type="double" default="0"/>
      <MetadataFields><Metadata description="Goes there."/></MetadataFields>
    </Action>
  </TreeNodesModel>
</root>
)");
}

TEST(ModelEdits, AModelGoesBehindTheOthers) {
  const Document document = Parsed(kModels);
  NodeModel model;
  model.id = "IsDark";
  model.category = NodeCategory::kCondition;
  EXPECT_NE(After(document, AddModel(document, model))
                .find("    </Action>\n    <Condition ID=\"IsDark\"/>\n  </TreeNodesModel>"),
            std::string::npos);
}

TEST(ModelEdits, TheLastModelTakesItsListAlong) {
  const Document document = Parsed(kModels);
  EXPECT_EQ(After(document, RemoveModel(document, FindModel(document, "Say"))),
            "<root BTCPP_format=\"4\">\n</root>\n");
}

TEST(ModelEdits, APortComesBeforeTheDescription) {
  const Document document = Parsed(kModels);
  const std::string text = After(document, AddPort(document, FindModel(document, "Say"),
                                                   {"loud", PortDirection::kInOut, "", "", {}}));
  EXPECT_NE(text.find("vendor=\"7\"/>\n      <inout_port name=\"loud\"/>\n      <Meta"),
            std::string::npos)
      << text;
}

TEST(ModelEdits, AChangedPortKeepsAttributesOfOthers) {
  const Document document = Parsed(kModels);
  const ElementIndex port = FindPort(document, FindModel(document, "Say"), "text");
  const std::string text =
      After(document,
            ChangePort(document, port, {"words", PortDirection::kOutput, "string", "a & b", "x"}));
  EXPECT_NE(text.find(R"(<output_port name="words" vendor="7" type="string" default="x">a &amp; b)"
                      "</output_port>\n"),
            std::string::npos)
      << text;
}

TEST(ModelEdits, ADescriptionStaysWhereItIs) {
  const Document document = Parsed(kModels);
  const ElementIndex say = FindModel(document, "Say");
  EXPECT_NE(After(document, DescribeModel(document, say, "Talks."))
                .find("<MetadataFields><Metadata description=\"Talks.\"/></MetadataFields>"),
            std::string::npos);
}

}  // namespace
}  // namespace coppice::editor
