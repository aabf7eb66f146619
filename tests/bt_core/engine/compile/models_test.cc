#include "bt_core/engine/compile/models.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

TEST(EscapeXml, ReadsBackTheSame) {
  const std::string text = "a<b>&\"c\" 'd'\n\r\t{x} \xC3\xA4";
  Diagnostics diagnostics;
  const auto document =
      Document::FromText("<a x=\"" + EscapeXml(text) + "\"/>", "t.xml", diagnostics);
  ASSERT_TRUE(document) << diagnostics.ToString();
  EXPECT_EQ(document->AttributeValue(document->element(kRootElement), "x"), text);
}

TEST(WriteModels, IsAProjectWithAModelForEveryNode) {
  Diagnostics diagnostics;
  const auto registry = TestRegistry();
  const auto document = Document::FromText(WriteModels(*registry), "t.xml", diagnostics);
  ASSERT_TRUE(document) << diagnostics.ToString();
  const Element& models = document->element(ElementIndex{1});
  EXPECT_EQ(models.tag, "TreeNodesModel");
  EXPECT_EQ(models.child_count, registry->entries().size());
}

TEST(WriteModels, DescribesThePorts) {
  const std::string xml = WriteModels(*TestRegistry());
  EXPECT_NE(xml.find(R"(<Action ID="Drive">)"), std::string::npos);
  EXPECT_NE(xml.find(R"(<input_port name="tries" type="int" default="3">how often</input_port>)"),
            std::string::npos);
  EXPECT_NE(xml.find(R"(<output_port name="distance" type="double">)"), std::string::npos);
  EXPECT_NE(xml.find(R"(<inout_port name="total" type="int">)"), std::string::npos);
}

TEST(WriteModels, ListsTheChoicesOfAnEnum) {
  EXPECT_NE(WriteModels(Registry()).find("IDLE, RUNNING, SUCCESS, FAILURE or SKIPPED</input_port>"),
            std::string::npos);
}

TEST(WriteModels, APortOfAnyTypeSaysSo) {
  EXPECT_NE(WriteModels(Registry()).find(R"(<input_port name="value" type="BT::AnyTypeAllowed">)"),
            std::string::npos);
}

TEST(DescribeNodes, NamesEveryNodeAndPort) {
  const std::string text = DescribeNodes(*TestRegistry());
  EXPECT_NE(text.find("Drive  (Action)\n  Drives.\n    input goal : double  where to [m]\n"
                      "    input tries : int = 3  how often\n"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace coppice
