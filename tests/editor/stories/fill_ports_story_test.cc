#include <gmock/gmock.h>

#include "tests/editor/driver.h"
#include "tests/editor/patrol_file.h"
#include "tests/editor/reference_picture.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;

TEST(FillPortsStory, PortsAreFilledInOnTheCanvas) {
  const TemporaryFile file("patrol.xml", kPatrolFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames(8);
  if (!driver.Has("canvas/Patrol/1.1.1/port/threshold")) driver.Click("canvasbar/ports");
  driver.Frames(30);
  const Point row = driver.BoxOf("canvas/Patrol/1.1.1/port/threshold").center();
  driver.ClickAt(row);
  driver.ClickAt(row);
  ASSERT_TRUE(driver.Has("canvas/edit/1.1.1/threshold"));
  driver.Press('A', kCtrl);
  driver.Type("0.4");
  driver.Press(kKeyTab);
  driver.Frames(30);
  ASSERT_TRUE(driver.Has("canvas/edit/1.1.2/goal")) << "of the next node";
  driver.Press('A', kCtrl);
  driver.Type("{go");
  EXPECT_EQ(CompareWithReference(driver.editor.Picture(), "story_fill_ports"), "");
  driver.Press(kKeyTab);
  driver.Press(kKeyEnter);
  const std::string text = driver.editor.state().workspace.project().Find(file.path())->text;
  EXPECT_THAT(text, HasSubstr("level=\"{battery}\" threshold=\"0.4\""));
  EXPECT_THAT(text, HasSubstr("name=\"to the station\" goal=\"{goal}\""));
}

}  // namespace
}  // namespace coppice::editor
