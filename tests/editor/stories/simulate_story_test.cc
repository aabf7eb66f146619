#include <gtest/gtest.h>

#include "tests/editor/driver.h"
#include "tests/editor/reference_picture.h"

namespace coppice::editor {
namespace {

constexpr char kFile[] = R"(<root BTCPP_format="4" main_tree_to_execute="Patrol">
  <BehaviorTree ID="Patrol">
    <ReactiveFallback name="patrol">
      <Sequence name="recharge">
        <ScriptCondition name="low?" code="battery &lt; 0.3"/>
        <GoTo name="to station" place="station"/>
        <Dock name="dock"/>
      </Sequence>
      <Sequence name="round">
        <GoTo name="to door" place="door"/>
        <Say name="say" text="All quiet."/>
      </Sequence>
    </ReactiveFallback>
  </BehaviorTree>
</root>
)";

TEST(SimulateStory, TheBatteryRunsLowOnARound) {
  const TemporaryFile file("patrol.xml", kFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames(8);
  driver.Press(kKeyF1 + 4);
  driver.Press('B', kCtrl);
  driver.Type("battery = 0.9");
  driver.Press(kKeyEnter);
  for (int i = 0; i < 5; ++i) driver.Press(kKeyF1 + 9);
  driver.Press('B', kCtrl);
  driver.Type("battery = 0.2");
  driver.Press(kKeyEnter);
  for (int i = 0; i < 3; ++i) driver.Press(kKeyF1 + 9);
  driver.Press(kKeyHome);
  driver.Frames(200);
  const RunView& run = *driver.editor.state().workspace.run();
  EXPECT_EQ(run.state().states[3].status, Status::kRunning) << "it drives to the station";
  EXPECT_EQ(CompareWithReference(driver.editor.Picture(), "story_simulate"), "");
}

}  // namespace
}  // namespace coppice::editor
