#include "editor/canvas/layout/node_metrics.h"

#include <gtest/gtest.h>

#include "editor/theme/icons.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(NodeMetrics, MakeRoomForTheWidestLine) {
  const TemporaryFile file(
      "wide.xml",
      R"(<root BTCPP_format="4"><BehaviorTree ID="T"><Sequence><A/>)"
      R"(<A x="12345678901234567890"/><A x="1" y="2"/></Sequence></BehaviorTree></root>)");
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  const Box plain = driver.BoxOf("canvas/T/1.1");
  const Box wide = driver.BoxOf("canvas/T/1.2");
  const Box tall = driver.BoxOf("canvas/T/1.3");
  EXPECT_GT(wide.width(), plain.width() + 40);
  EXPECT_NEAR(tall.height() - wide.height(), metrics::kLine * driver.view().camera.zoom, 1);
}

TEST(NodeMetrics, CutLongValuesAtACharacter) {
  const std::string shown =
      ShownValue(std::string(30, 'a') + "\xC3\xA4\xC3\xB6\xC3\xBC\xC3\x9F...");
  EXPECT_EQ(shown, std::string(30, 'a') + "\xC3\xA4\xC3\xB6\xC3\xBC\xC3\x9F" + icon::kEllipsis);
  EXPECT_EQ(ShownValue("a\nb"), "a b");
}

TEST(NodeMetrics, GiveATypeTheSignThatItsNodesHave) {
  SceneNode node;
  node.shape = Shape::kControl;
  node.id = "ReactiveFallback";
  node.name = "patrol";
  EXPECT_EQ(GlyphOf(Shape::kControl, "ReactiveFallback"), GlyphOf(node));
  EXPECT_NE(GlyphOf(Shape::kControl, "ReactiveFallback"), GlyphOf(Shape::kControl, "Sequence"));
  EXPECT_NE(GlyphOf(Shape::kDecorator, "Inverter"), GlyphOf(Shape::kDecorator, "Timeout"));
  EXPECT_NE(GlyphOf(Shape::kControl, "Switch2"), GlyphOf(Shape::kSubTree, "Switch2"))
      << "the glyph stands alone in the outline";
}

TEST(NodeMetrics, MakeRoomForTheArrowOfAnOutputPort) {
  const auto width_of = [](const char* direction) {
    const std::string port = std::string("<") + direction + R"( name="goal" type="int"/>)";
    const TemporaryFile file("ports.xml",
                             R"(<root BTCPP_format="4"><BehaviorTree ID="T"><Plan )"
                             R"(goal="{a_long_key_of_the_robot}"/></BehaviorTree><TreeNodesModel>)"
                             R"(<Action ID="Plan">)" +
                                 port + "</Action></TreeNodesModel></root>");
    Driver driver;
    EXPECT_TRUE(driver.editor.Open(file.path()));
    driver.Frames();
    return driver.BoxOf("canvas/T/1").width();
  };
  EXPECT_NEAR(width_of("output_port"), width_of("input_port") + metrics::kArrow, 1);
}

TEST(NodeMetrics, NameTheTypeWhenTheNameDoesNot) {
  SceneNode node;
  node.id = "NavigateTo";
  node.name = "NavigateTo";
  EXPECT_EQ(TypeLineOf(node), "");
  node.name = "to the door";
  EXPECT_EQ(TypeLineOf(node), "NavigateTo");
  node.id = "Sequence";
  EXPECT_EQ(TypeLineOf(node), "") << "the arrow says it";
}

}  // namespace
}  // namespace coppice::editor
