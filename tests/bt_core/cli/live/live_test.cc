#include <gmock/gmock.h>

#include <csignal>
#include <future>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/bt_core/cli/awaited_output.h"
#include "tests/bt_core/cli/fixture.h"
#include "tests/bt_core/live/robot.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class LiveTest : public CliTest {};

TEST_F(LiveTest, ShowsOnceHowThingsStand) {
  Robot robot;
  robot.Tick(3);
  EXPECT_EQ(Run(RunLive, {robot.endpoint(), "--once", "--board"}), 0);
  EXPECT_THAT(out_, HasSubstr("Main  tick 3  RUNNING"));
  EXPECT_THAT(out_, HasSubstr("> top & first [ReactiveSequence]  RUNNING\n"));
  EXPECT_THAT(out_, HasSubstr("Main/number = 3\n"));
  EXPECT_THAT(out_, Not(HasSubstr("\x1b")));  // this is no terminal
}

TEST_F(LiveTest, SendsCommandsAndSaysWhatIsWrongWithThem) {
  Robot robot;
  EXPECT_EQ(Run(RunLive, {robot.endpoint(), "--once", "--set", "number=17"}), 0);
  EXPECT_EQ(Run(RunLive, {robot.endpoint(), "--once", "--break", "Fill", "--if", "numbr > 1"}), 1);
  EXPECT_THAT(err_, HasSubstr("--break Fill: "));
  EXPECT_THAT(err_, HasSubstr(R"(did you mean "number"?)"));
  EXPECT_EQ(Run(RunLive, {robot.endpoint(), "--once", "--break", "Fil::2"}), 0);
  EXPECT_THAT(err_, HasSubstr(R"(did you mean "Fill::2"?)"));  // a remark: it may come
}

TEST_F(LiveTest, SaysThatNobodyElseHasLeftAHook) {
  Robot robot;
  EXPECT_EQ(Run(RunLive, {robot.endpoint(), "--once", "--unhook", "Fill::2"}), 1);
  EXPECT_THAT(err_, HasSubstr("--unhook Fill::2: no other client has left anything there"));
}

TEST_F(LiveTest, PrintsEveryTickAsJsonUntilItIsInterrupted) {
  Robot robot;
  robot.Tick(5);
  AwaitedOutput output(std::cout);
  auto verb = std::async(std::launch::async, [&] {
    return RunLive({robot.endpoint(), "--json", "--past"});
  });
  EXPECT_TRUE(output.Await(R"("tick":5,)"));
  std::raise(SIGINT);
  EXPECT_EQ(verb.get(), 0);
  std::istringstream lines(output.text());
  int last_tick = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto json = nlohmann::json::parse(line);
    if (json["type"] == "tick") {
      EXPECT_EQ(json["tick"], last_tick + 1);
      last_tick = json["tick"];
    }
  }
  EXPECT_EQ(last_tick, 5);
}

TEST_F(LiveTest, SaysThatThereIsNoRobot) {
  EXPECT_EQ(Run(RunLive, {"127.0.0.1:1", "--once"}), 1);
  EXPECT_THAT(err_, HasSubstr("no answer from 127.0.0.1:1"));
}

TEST_F(LiveTest, NeedsOneRobotAndRightOptions) {
  EXPECT_EQ(Run(RunLive, {}), 2);
  EXPECT_EQ(Run(RunLive, {"a", "b"}), 2);
  EXPECT_EQ(Run(RunLive, {"a:b"}), 2);
  EXPECT_THAT(err_, HasSubstr("expected HOST:PORT"));
  EXPECT_EQ(Run(RunLive, {"a", "--inject", "x"}), 2);
  EXPECT_EQ(Run(RunLive, {"a", "--nonsense"}), 2);
}

}  // namespace
}  // namespace coppice
