#include <gmock/gmock.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;

class NodePage : public testing::Test {
 protected:
  NodePage() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }
  std::string Text() { return driver_.editor.state().workspace.project().Find(file_.path())->text; }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(NodePage, ASubTreeShowsWhatItsTreeShares) {
  driver_.Click("canvas/MainTree/1.2");
  ASSERT_TRUE(driver_.Has("inspector/port/goal"));
  ASSERT_TRUE(driver_.Click("inspector/port/goal/clear"));
  EXPECT_THAT(Text(), HasSubstr(R"(<SubTree ID="Walk" name="walk"/>)"));
  EXPECT_TRUE(driver_.Has("inspector/port/goal")) << "not given";
}

TEST_F(NodePage, AutoremapIsASwitch) {
  driver_.Click("canvas/MainTree/1.2");
  ASSERT_TRUE(driver_.Click("inspector/autoremap/toggle"));
  EXPECT_THAT(Text(), HasSubstr(R"(_autoremap="true")"));
  ASSERT_TRUE(driver_.Click("inspector/autoremap/clear"));
  EXPECT_EQ(Text(), kSmallFile);
}

TEST_F(NodePage, ANodeOfAnUnknownTypeGetsAnyPort) {
  driver_.Click("canvas/MainTree/1.2.1.1");
  ASSERT_EQ(driver_.Selected(), "1.2.1.1");
  driver_.Press('I', kShift);
  driver_.Type("speed");
  driver_.Press(kKeyEnter);
  driver_.Type("0.5");
  driver_.Press(kKeyEnter);
  EXPECT_THAT(Text(), HasSubstr(R"(<Step to="{goal}" speed="0.5"/>)"));
}

TEST_F(NodePage, WhatIsNoNameOfAPortIsRefused) {
  driver_.Click("canvas/MainTree/1.2.1.1");
  driver_.Press('I', kShift);
  driver_.Type("a b");
  driver_.Press(kKeyEnter);
  EXPECT_EQ(Text(), kSmallFile);
  EXPECT_THAT(driver_.editor.state().notice.text, HasSubstr("cannot be the name of a port"));
}

TEST(NodePageOfALongValue, ShowsItsBeginningWithoutAFieldForIt) {
  const TemporaryFile file("long.xml",
                           R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Use map=")" +
                               std::string(5 << 20, 'x') + R"(" room="5"/></BehaviorTree></root>)");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames(8);
  driver.Click("canvas/Main/1");
  driver.Frames();
  EXPECT_TRUE(driver.Has("inspector/port/map"));
  EXPECT_FALSE(driver.Has("inspector/port/map/clear"));
  EXPECT_TRUE(driver.Has("inspector/port/room/clear"));
}

}  // namespace
}  // namespace coppice::editor
