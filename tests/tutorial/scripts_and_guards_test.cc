#include <gtest/gtest.h>

#include <cstdint>
#include <functional>

#include "bt_core/engine/executor.h"
#include "tests/tutorial/room.h"

namespace coppice {
namespace {

// [tree]
constexpr char kSaving[] = R"(
<root BTCPP_format="4">
  <BehaviorTree ID="Saving">
    <Sequence>
      <Script code="switched := 0; bright := lux >= 10"/>
      <SwitchOn _skipIf="bright" _onSuccess="switched += 1"/>
    </Sequence>
  </BehaviorTree>
</root>)";
// [tree end]

// [test]
class Saving : public testing::Test {
 protected:
  Saving() { registry_->Register<SwitchOn>("SwitchOn", std::ref(lamp_)); }

  // Ticks the tree once; returns what it has counted.
  std::int64_t CountAt(double lux) {
    SimulatedClock clock;
    Executor executor(Load(kSaving, registry_), clock);
    executor.Writer<double>("lux").Send(lux);
    EXPECT_EQ(executor.Tick(), Status::kSuccess);
    const SlotIndex slot = executor.program().layout.Find(kMainScope, "switched");
    return executor.blackboard()[slot].value.Get<std::int64_t>();
  }

  Lamp lamp_;
  std::shared_ptr<Registry> registry_ = std::make_shared<Registry>();
};

TEST_F(Saving, InTheDarkTheLampIsSwitchedOnAndCounted) {
  EXPECT_EQ(CountAt(3.0), 1);
  EXPECT_TRUE(lamp_.is_on);
}

TEST_F(Saving, InTheLightTheLampIsSkipped) {
  EXPECT_EQ(CountAt(500.0), 0);
  EXPECT_FALSE(lamp_.is_on);
}
// [test end]

}  // namespace
}  // namespace coppice
