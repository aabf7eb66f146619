#include "editor/panels/widgets/port_editor.h"

#include <gmock/gmock.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;

class PortEditorTest : public testing::Test {
 protected:
  PortEditorTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames(8);
    driver_.Click("canvas/MainTree/1.1.2");
    driver_.Press(kKeyEnter, kShift);
  }
  std::string Text() { return driver_.editor.state().workspace.project().Find(file_.path())->text; }
  void Fill(const std::string& text) {
    driver_.Press('A', kCtrl);
    driver_.Type(text);
  }
  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(PortEditorTest, ShiftEnterEditsTheFirstPortOnTheNode) {
  ASSERT_TRUE(driver_.Has("canvas/edit/1.1.2/level"));
  Fill("7");
  driver_.Press(kKeyEnter);
  EXPECT_THAT(Text(), HasSubstr("<SwitchOn lamp=\"hall\" level=\"7\"/>"));
  EXPECT_FALSE(driver_.Has("canvas/edit/1.1.2/level"));
}

TEST_F(PortEditorTest, EscTakesBackWhatWasTyped) {
  Fill("7");
  driver_.Press(kKeyEscape);
  EXPECT_EQ(Text(), kSmallFile);
  EXPECT_FALSE(driver_.Has("canvas/edit/1.1.2/level"));
}

TEST_F(PortEditorTest, TabGoesToTheNextPortAndThenToTheNextNode) {
  Fill("7");
  driver_.Press(kKeyTab);
  ASSERT_TRUE(driver_.Has("canvas/edit/1.1.2/lamp"));
  Fill("door");
  driver_.Press(kKeyTab);
  ASSERT_TRUE(driver_.Has("canvas/edit/1.1.2/slowly")) << "a port that is not given yet";
  driver_.Press(kKeyTab);
  ASSERT_TRUE(driver_.Has("canvas/edit/1.2/goal"));
  EXPECT_EQ(driver_.Selected(), "1.2");
  EXPECT_THAT(Text(), HasSubstr("<SwitchOn lamp=\"door\" level=\"7\"/>"));
}

TEST_F(PortEditorTest, ShiftTabGoesBack) {
  driver_.Press(kKeyTab, kShift);
  EXPECT_EQ(driver_.Selected(), "1.1.1.1");
}

TEST_F(PortEditorTest, TabCompletesAKeyFirst) {
  Fill("{li");
  driver_.Press(kKeyTab);
  driver_.Press(kKeyEnter);
  EXPECT_THAT(Text(), HasSubstr("level=\"{light}\""));
}

}  // namespace
}  // namespace coppice::editor
