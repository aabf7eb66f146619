#include <gtest/gtest.h>

#include "bt_core/engine/executor.h"
#include "tests/tutorial/room.h"

namespace coppice {
namespace {

// [tree]
constexpr char kFlat[] = R"(
<root BTCPP_format="4" main_tree_to_execute="Flat">
  <BehaviorTree ID="Flat">
    <Sequence>
      <SubTree ID="Room" brightness="{hall}"/>
      <SubTree ID="Room" brightness="{kitchen}" limit="100"/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Room">
    <IsDark lux="{brightness}" limit="{limit}"/>
  </BehaviorTree>
  <TreeNodesModel>
    <SubTree ID="Room">
      <input_port name="brightness"/>
      <input_port name="limit" default="10"/>
    </SubTree>
  </TreeNodesModel>
</root>)";
// [tree end]

// [test]
TEST(Flat, EveryRoomHasItsOwnBrightnessAndLimit) {
  auto registry = std::make_shared<Registry>();
  registry->Register<IsDark>("IsDark");
  SimulatedClock clock;
  Executor executor(Load(kFlat, registry), clock);
  executor.Writer<double>("hall").Send(3.0);
  executor.Writer<double>("kitchen").Send(50.0);
  EXPECT_EQ(executor.Tick(), Status::kSuccess);
  executor.Writer<double>("hall").Send(50.0);
  EXPECT_EQ(executor.Tick(), Status::kFailure);
}
// [test end]

}  // namespace
}  // namespace coppice
