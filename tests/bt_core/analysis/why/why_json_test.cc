// Answers to WHY as JSON.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/bt_core/analysis/asked_run.h"

namespace coppice {
namespace {

using nlohmann::json;

json Answer(const RecordedRun& run, const std::string& node) {
  return json::parse(Asked(run.keeper.run).Json(node));
}

TEST(WhyJson, SaysOfANodeThatWasTickedWhyItEndedSo) {
  RecordedRun run(kPatrol, Lamps());
  const Sender<double> battery = run.executor.Writer<double>("battery");
  battery.Send(50);
  run.executor.Writer<double>("lux").Send(30);
  run.Tick();
  battery.Send(12);
  run.Tick();
  const json answer = Answer(run, "battery_low");
  EXPECT_EQ(answer["tick"], 2);
  EXPECT_EQ(answer["time"], 0.1);
  EXPECT_EQ(answer["node"], "battery_low");
  EXPECT_EQ(answer["status"], "IDLE")
      << "the whole tree has ended, so nothing below it has a status";
  EXPECT_EQ(answer["ticked"], true);
  EXPECT_FALSE(answer.contains("why_not"));
  const json& step = answer["steps"].back();
  EXPECT_EQ(step["result"], "SUCCESS");
  EXPECT_EQ(step["before"], "FAILURE");
  EXPECT_EQ(step["cause"], "script");
  EXPECT_EQ(step["script"]["attribute"], "code");
  EXPECT_EQ(step["script"]["answer"], true);
  EXPECT_EQ(step["script"]["values"][0],
            json({{"name", "battery"}, {"key", "battery"}, {"value", 12}, {"before", 50}}));
  EXPECT_EQ(answer["first_change"]["node"], "battery_low");
}

TEST(WhyJson, SaysOfANodeThatWasNotTickedWhoDidNotComeToIt) {
  RecordedRun run(kPatrol, Lamps());
  run.executor.Writer<double>("battery").Send(5);
  run.executor.Writer<double>("lux").Send(3);
  run.Tick();
  const json answer = Answer(run, "drive");
  EXPECT_EQ(answer["ticked"], false);
  EXPECT_EQ(answer["why_not"]["cause"], "child");
  EXPECT_EQ(answer["why_not"]["by"], "root");
  EXPECT_EQ(answer["why_not"]["towards"], "work");
  EXPECT_EQ(answer["why_not"]["child"], "safety");
  EXPECT_EQ(answer["why_not"]["status"], "SUCCESS");
  EXPECT_EQ(answer["why_not"]["text"], Asked(run.keeper.run).WhyNotText("drive"));
}

TEST(WhyJson, HasTheTextOfAnExceptionAndOfAScriptThatThrew) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><ScriptCondition name='c' code='nobody &lt; 1'/>"
      "</BehaviorTree>");
  run.Tick();
  const json step = Answer(run, "c")["steps"].back();
  EXPECT_EQ(step["cause"], "exception");
  EXPECT_FALSE(step["exception"].get<std::string>().empty());
  EXPECT_EQ(step["result"], "FAILURE");
}

TEST(WhyJson, TextsOfUsersAreEscaped) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><AlwaysSuccess name='say &quot;no&quot;\\'/>"
      "</BehaviorTree>");
  run.Tick();
  EXPECT_EQ(json::parse(Asked(run.keeper.run).Json("say \"no\"\\"))["node"], "say \"no\"\\");
}

}  // namespace
}  // namespace coppice
