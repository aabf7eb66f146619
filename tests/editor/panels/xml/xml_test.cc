#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Xml, ScrollsToTheLineOfTheSelectedNodeAndMarksIt) {
  std::string xml = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\"><Sequence>\n";
  for (int i = 0; i < 200; ++i) xml += "<AlwaysSuccess/>\n";
  const TemporaryFile file("long.xml", xml + "</Sequence></BehaviorTree></root>\n");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.OpenRow();
  EXPECT_FALSE(driver.Has("xml/151"));
  driver.view().Select(driver.view().scene()->FindPath("1.150"));
  driver.Frames();
  ASSERT_TRUE(driver.Has("xml/151"));
  const Box row = driver.BoxOf("xml/151");
  const Box edge = {row.min, {row.min.x + 3, row.max.y}};
  const Color accent = GetPalette(PaletteName::kDark).accent;
  EXPECT_GT(driver.CountColor(edge, accent, 4), 30);
  const Box other = driver.BoxOf("xml/152");
  EXPECT_EQ(driver.CountColor({other.min, {other.min.x + 3, other.max.y}}, accent, 4), 0);
}

TEST(Xml, ATagThatIsIndentedFarIsBroughtIntoSight) {
  const std::string blanks(200, ' ');
  const TemporaryFile file("far.xml",
                           "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\"><Sequence>\n" + blanks +
                               "<AlwaysSuccess/>\n<AlwaysFailure/>\n"
                               "</Sequence></BehaviorTree></root>\n");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.OpenRow();
  driver.view().Select(driver.view().scene()->FindPath("1.1"));
  driver.Frames();
  EXPECT_GT(driver.editor.state().xml.pane.left, 500);
  driver.view().Select(driver.view().scene()->FindPath("1.2"));
  driver.Frames();
  EXPECT_EQ(driver.editor.state().xml.pane.left, 0);
}

TEST(Xml, AnotherFileIsShownFromItsBeginning) {
  std::string xml = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\"><Sequence>\n";
  for (int i = 0; i < 200; ++i) xml += "<AlwaysSuccess/>\n";
  xml += "</Sequence></BehaviorTree></root>\n";
  const TemporaryFile file("long.xml", xml);
  const TemporaryFile other("other.xml", xml);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.OpenRow();
  driver.view().Select(driver.view().scene()->FindPath("1.150"));
  driver.Frames();
  ASSERT_FALSE(driver.Has("xml/1"));
  driver.editor.Open(other.path());
  driver.Frames();
  EXPECT_TRUE(driver.Has("xml/1"));
}

class XmlTypingTest : public testing::Test {
 protected:
  XmlTypingTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
    driver_.OpenRow();
  }
  const std::string& Text() {
    return driver_.editor.state().workspace.project().Find(file_.path())->text;
  }
  void ClickBehind(const std::string& line) { driver_.ClickAt(End(line)); }
  Point End(const std::string& line) const {
    const Box box = driver_.BoxOf("xml/" + line);
    return {box.max.x - 20, box.center().y};
  }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(XmlTypingTest, WhatIsTypedChangesTheTree) {
  ClickBehind("4");
  EXPECT_EQ(driver_.Selected(), "");
  driver_.Press(kKeyEnter);
  driver_.Type(R"(  <Beep tone="high"/>)");
  EXPECT_NE(Text().find("round\">\n      <Beep tone=\"high\"/>\n"), std::string::npos) << Text();
  EXPECT_TRUE(driver_.Has("canvas/MainTree/1.4"));
  EXPECT_EQ(driver_.Selected(), "1");
  driver_.Picture("xml_typing");
  driver_.Press(kKeyLeft);
  EXPECT_EQ(driver_.Selected(), "1.1");
}

TEST_F(XmlTypingTest, AnErrorIsShownAtItsPlaceAndTheTreeStays) {
  ClickBehind("4");
  driver_.Type("<Beep");
  EXPECT_TRUE(driver_.editor.state().workspace.file()->is_stale);
  EXPECT_TRUE(driver_.Has("canvas/MainTree/1.3"));
  driver_.Frames(10);
  EXPECT_TRUE(driver_.Has("xml/problem/5") || driver_.Has("xml/problem/4"));
  driver_.Picture("xml_error");
  driver_.Type("/>");
  EXPECT_FALSE(driver_.editor.state().workspace.file()->is_stale);
  EXPECT_TRUE(driver_.Has("canvas/MainTree/1.4"));
}

TEST_F(XmlTypingTest, AWordIsOneStepOfTheHistory) {
  ClickBehind("4");
  for (const char* letter : {"<", "A", "/", ">"}) driver_.Type(letter);
  EXPECT_EQ(driver_.editor.state().workspace.project().history().done(), 1U);
  driver_.Press('Z', kCtrl);
  EXPECT_EQ(Text(), kSmallFile);
  EXPECT_FALSE(driver_.editor.state().workspace.file()->is_stale);
}

TEST_F(XmlTypingTest, KeysAreForTheTextUntilEscape) {
  ClickBehind("4");
  driver_.Press('D');
  driver_.Press(kKeyDelete);
  EXPECT_EQ(Text().find("_skipIf"), std::string::npos);
  driver_.Press('Z', kCtrl);
  driver_.Press(kKeyEscape);
  driver_.view().Select(driver_.view().scene()->FindPath("1.3"));
  driver_.Press('D');
  EXPECT_NE(Text().find("_skipIf"), std::string::npos);
}

TEST_F(XmlTypingTest, ACommandGoesToTheTextOfTheNode) {
  driver_.view().Select(driver_.view().scene()->FindPath("1.3"));
  driver_.Press(kKeyEnter, kCtrl);
  EXPECT_TRUE(driver_.Has("xml/caret"));
  EXPECT_EQ(driver_.editor.state().xml.pane.at, Text().find("<AlwaysSuccess"));
  driver_.Press(kKeyEnd, kShift);
  driver_.Press('X', kCtrl);
  EXPECT_EQ(driver_.editor.state().services.get_clipboard(), "<AlwaysSuccess/>");
  EXPECT_EQ(Text().find("<AlwaysSuccess"), std::string::npos);
}

TEST_F(XmlTypingTest, AMalformedTextIsSavedAsItIs) {
  ClickBehind("4");
  driver_.Type("<");
  driver_.Press('S', kCtrl);
  std::ifstream stream(file_.path(), std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), Text());
}

TEST_F(XmlTypingTest, ARobotsTreeIsReadOnly) {
  driver_.AddRobot("robot:1", kLiveTree);
  ClickBehind("3");
  driver_.Type("x");
  EXPECT_FALSE(driver_.Has("xml/caret"));
}

TEST_F(XmlTypingTest, TheEndOfALongLineIsScrolledTo) {
  ClickBehind("4");
  driver_.Press(kKeyEnd);
  driver_.Type("<!-- " + std::string(200, 'x') + " -->");
  driver_.Frames();
  const Box caret = driver_.BoxOf("xml/caret");
  const Box tile = driver_.BoxOf("xml");
  EXPECT_LT(caret.max.x, tile.max.x);
  EXPECT_GT(caret.min.x, tile.center().x);
  driver_.Press(kKeyHome);
  driver_.Frames();
  EXPECT_GT(driver_.BoxOf("xml/caret").min.x, tile.min.x);
  EXPECT_LT(driver_.BoxOf("xml/caret").min.x, tile.center().x);
}

}  // namespace
}  // namespace coppice::editor
