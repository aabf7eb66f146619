#include <gtest/gtest.h>

#include "editor/workspace/tour.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class WheelStory : public testing::Test {
 protected:
  WheelStory() {
    driver_.editor.Open(file_.path());
    driver_.Frames(20);
    driver_.MoveTo(BoxOf("1.1").center());
  }
  Box BoxOf(const std::string& node) const { return driver_.BoxOf("canvas/MainTree/" + node); }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(WheelStory, TheWheelScrollsTheCanvas) {
  const Box before = BoxOf("1");
  driver_.Wheel(-1);
  EXPECT_LT(BoxOf("1").min.y, before.min.y);
  EXPECT_EQ(BoxOf("1").min.x, before.min.x);
  EXPECT_EQ(BoxOf("1").width(), before.width());
}

TEST_F(WheelStory, TwoFingersGoAnywhere) {
  const Box before = BoxOf("1");
  driver_.Wheel(0.5F, -0.25F);
  EXPECT_GT(BoxOf("1").min.y, before.min.y);
  EXPECT_LT(BoxOf("1").min.x, before.min.x);
}

TEST_F(WheelStory, ShiftScrollsSideways) {
  const Box before = BoxOf("1");
  driver_.Hold(kShift);
  driver_.Wheel(1);
  driver_.Hold(kNoModifier);
  EXPECT_GT(BoxOf("1").min.x, before.min.x);
  EXPECT_EQ(BoxOf("1").min.y, before.min.y);
}

TEST_F(WheelStory, CtrlZoomsAtTheMouse) {
  const Box before = BoxOf("1.1");
  driver_.Zoom(1);
  EXPECT_GT(BoxOf("1.1").width(), before.width());
  EXPECT_NEAR(BoxOf("1.1").center().x, before.center().x, 1);
}

TEST_F(WheelStory, TheViewMenuTurnsItRoundAndTheTourSaysSo) {
  driver_.Click("menu/view");
  ASSERT_TRUE(driver_.Click("menu/view.wheel_zooms"));
  driver_.MoveTo(BoxOf("1.1").center());
  const Box before = BoxOf("1");
  driver_.Wheel(1);
  EXPECT_GT(BoxOf("1").width(), before.width());
  driver_.editor.state().commands.Run("help.tour");
  driver_.Frames();
  driver_.Picture("tour_of_the_wheel");
  const EditorState& state = driver_.editor.state();
  EXPECT_NE(TextOf(*ShownStep(state), state).find("The wheel zooms"), std::string::npos);
}

}  // namespace
}  // namespace coppice::editor
