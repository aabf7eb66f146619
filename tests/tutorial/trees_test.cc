#include <gtest/gtest.h>

#include <chrono>
#include <functional>

#include "bt_core/engine/executor.h"
#include "tests/tutorial/room.h"

namespace coppice {
namespace {

// [tree]
constexpr char kEvening[] = R"(
<root BTCPP_format="4">
  <BehaviorTree ID="Evening">
    <Sequence>
      <IsDark lux="{lux}"/>
      <Delay delay_msec="2000"> <SwitchOn/> </Delay>
    </Sequence>
  </BehaviorTree>
</root>)";
// [tree end]

// [test]
TEST(Evening, SwitchesTheLampOnAfterTwoSeconds) {
  Lamp lamp;
  auto registry = std::make_shared<Registry>();
  registry->Register<IsDark>("IsDark");
  registry->Register<SwitchOn>("SwitchOn", std::ref(lamp));

  SimulatedClock clock;
  Executor executor(Load(kEvening, registry), clock);
  executor.Writer<double>("lux").Send(3.0);
  EXPECT_EQ(executor.Tick(), Status::kRunning);
  EXPECT_FALSE(lamp.is_on);
  clock.Advance(std::chrono::seconds(2));
  EXPECT_EQ(executor.Tick(), Status::kSuccess);
  EXPECT_TRUE(lamp.is_on);
}
// [test end]

// [mistake]
TEST(Evening, AMistakeIsFoundWhenTheTreeIsLoaded) {
  auto registry = std::make_shared<Registry>();
  registry->Register<IsDark>("IsDark");
  try {
    Load(R"(<root BTCPP_format="4"><BehaviorTree ID="A"><IsDrak/></BehaviorTree></root>)",
         registry);
    FAIL() << "it was loaded";
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find("room.xml:1:"), 0U) << text;
    EXPECT_NE(text.find("IsDark"), std::string::npos) << text;
  }
}
// [mistake end]

}  // namespace
}  // namespace coppice
