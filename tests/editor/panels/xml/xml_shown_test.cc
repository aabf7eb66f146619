#include "editor/panels/xml/xml_shown.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(XmlShown, IsTheFileOfTheSelectedNodeWithItsStartTag) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.view().Select(driver.view().scene()->FindPath("1.3"));
  const ShownXml shown = ChooseXml(driver.editor.state(), &driver.view());
  EXPECT_EQ(shown.path, file.path());
  EXPECT_TRUE(shown.can_edit);
  EXPECT_EQ(shown.text->substr(shown.begin, shown.end - shown.begin), "<AlwaysSuccess/>");
}

// A check of the blackboard is two nodes of format 4.
TEST(XmlShown, FindsANodeOfAnOldFileInItsText) {
  const TemporaryFile file(
      "old.xml",
      "<root main_tree_to_execute=\"A\"><BehaviorTree ID=\"A\"><Sequence>"
      R"(<BlackboardCheckInt value_A="{n}" value_B="3" return_on_mismatch="FAILURE">)"
      "<AlwaysSuccess/></BlackboardCheckInt><AlwaysFailure/></Sequence></BehaviorTree></root>");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.view().Select(driver.view().scene()->FindPath("1.2"));
  const ShownXml shown = ChooseXml(driver.editor.state(), &driver.view());
  EXPECT_EQ(shown.text->substr(shown.begin, shown.end - shown.begin), "<AlwaysFailure/>");
}

TEST(XmlShown, OfAMalformedFileItIsTheText) {
  const TemporaryFile file("bad.xml", "<root><BehaviorTree>");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  const ShownXml shown = ChooseXml(driver.editor.state(), nullptr);
  ASSERT_NE(shown.text, nullptr);
  EXPECT_EQ(*shown.text, "<root><BehaviorTree>");
  EXPECT_EQ(shown.end, 0U);
}

}  // namespace
}  // namespace coppice::editor
