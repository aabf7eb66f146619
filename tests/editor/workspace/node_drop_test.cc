#include "editor/workspace/node_drop.h"

#include <gmock/gmock.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;

class NodeDropTest : public testing::Test {
 protected:
  NodeDropTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }
  const std::string& Text() {
    return driver_.editor.state().workspace.project().Find(file_.path())->text;
  }
  Point Center(const std::string& path) const { return driver_.BoxOf(path).center(); }
  // At the left edge of a node: the gap before it.
  Point Before(const std::string& path) const {
    const Box box = driver_.BoxOf(path);
    return {box.min.x + 3, box.center().y};
  }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(NodeDropTest, ANodeIsDraggedBetweenOthers) {
  driver_.Drag(Center("canvas/MainTree/1.3"), Before("canvas/MainTree/1.1"));
  EXPECT_THAT(Text(), HasSubstr("<Sequence name=\"round\">\n      <AlwaysSuccess/>\n      <Fall"));
  EXPECT_EQ(driver_.Selected(), "1.1");
  driver_.Press('Z', kCtrl);
  EXPECT_EQ(Text(), kSmallFile);
}

TEST_F(NodeDropTest, ATypeIsDraggedOutOfItsTileOntoANode) {
  ASSERT_TRUE(driver_.Click("types/filter"));
  driver_.Type("SwitchOn");
  ASSERT_TRUE(driver_.Has("types/SwitchOn"));
  driver_.Drag(Center("types/SwitchOn"), Center("canvas/MainTree/1.1"));
  EXPECT_THAT(Text(), HasSubstr("level=\"{level}\"/>\n        <SwitchOn/>\n      </Fallback>"));
}

TEST_F(NodeDropTest, ANodeIsDraggedOutOfTheOutline) {
  driver_.Drag(Center("outline/1.3"), Center("canvas/MainTree/1.1"));
  EXPECT_THAT(Text(), HasSubstr("<AlwaysSuccess/>\n      </Fallback>"));
}

TEST_F(NodeDropTest, WhatIsNotPossibleIsSaidBesideTheMouse) {
  const Point from = Center("canvas/MainTree/1.1");
  const Point to = Center("canvas/MainTree/1.1.2");
  driver_.MoveTo(from);
  driver_.input.events.push_back(MouseButton{0, true});
  driver_.Frames(1);
  driver_.MoveTo({from.x + 20, from.y});
  driver_.MoveTo(to);
  EXPECT_TRUE(driver_.Has("canvas/ghost"));
  EXPECT_THAT(driver_.editor.state().drag.answer.refusal, HasSubstr("itself"));
  driver_.Picture("drop_refused");
  driver_.input.events.push_back(MouseButton{0, false});
  driver_.Frames();
  EXPECT_EQ(Text(), kSmallFile);
}

TEST_F(NodeDropTest, ShiftCopies) {
  const Point from = Center("canvas/MainTree/1.3");
  driver_.input.events.push_back(KeyEvent{340, true, kShift});
  driver_.Frames(1);
  driver_.Drag(from, Center("canvas/MainTree/1.1"));
  EXPECT_THAT(Text(), HasSubstr("<AlwaysSuccess/>\n      </Fallback>"));
  EXPECT_THAT(Text(), HasSubstr("<AlwaysSuccess/>\n    </Sequence>"));
}

}  // namespace
}  // namespace coppice::editor
