#include <gtest/gtest.h>

#include <functional>
#include <future>

#include "bt_core/engine/runner.h"
#include "tests/tutorial/room.h"

namespace coppice {
namespace {

// [tree]
constexpr char kDusk[] = R"(
<root BTCPP_format="4">
  <BehaviorTree ID="Dusk">
    <Sequence>
      <ReactiveFallback name="until it is dark">
        <IsDark lux="{lux}"/>
        <Sleep msec="3600000"/>
      </ReactiveFallback>
      <SwitchOn/>
    </Sequence>
  </BehaviorTree>
</root>)";
// [tree end]

class Running : public testing::Test {
 protected:
  Running() {
    registry_->Register<IsDark>("IsDark");
    registry_->Register<SwitchOn>("SwitchOn", std::ref(lamp_));
  }
  Lamp lamp_;
  std::shared_ptr<Registry> registry_ = std::make_shared<Registry>();
};

// [test]
TEST_F(Running, TheLampGoesOnWhenTheSensorSaysSo) {
  WallClock clock;
  Executor executor(Load(kDusk, registry_), clock);
  const Sender<double> lux = executor.Writer<double>("lux");
  Runner runner(executor, {Pace::kEvents, kForever});
  std::future<Status> result = std::async(std::launch::async, [&] { return runner.Run(); });

  lux.Send(500.0);  // from any thread; too bright, the tree goes on sleeping
  lux.Send(3.0);
  EXPECT_EQ(result.get(), Status::kSuccess);
  EXPECT_TRUE(lamp_.is_on);
}
// [test end]

// [stop]
constexpr char kNight[] = R"(
<root BTCPP_format="4">
  <BehaviorTree ID="Night">
    <Sequence> <SwitchOn/> <Begin/> <Sleep msec="3600000"/> </Sequence>
  </BehaviorTree>
</root>)";

TEST_F(Running, StopHaltsTheTree) {
  std::promise<void> begun;
  registry_->Action("Begin", [&begun] {
    begun.set_value();
    return Status::kSuccess;
  });
  WallClock clock;
  Executor executor(Load(kNight, registry_), clock);
  Runner runner(executor, {Pace::kEvents, kForever});
  std::future<Status> result = std::async(std::launch::async, [&] { return runner.Run(); });

  begun.get_future().wait();
  runner.Stop();
  EXPECT_EQ(executor.statuses()[0], Status::kIdle);
  EXPECT_EQ(result.get(), Status::kRunning);
}
// [stop end]

}  // namespace
}  // namespace coppice
