#include "robot_app/processes/config/robot_config_fields.h"

#include <utility>

#include "robot_app/common/ros_name.h"

namespace coppice::robot::processes {
namespace {

double ToSeconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

// "topic /NAME" and "service /NAME".
bool ReadNamed(const std::string& text, const std::string& kind, Readiness readiness,
               ProcessConfig& process) {
  if (text.rfind(kind + " ", 0) != 0 || !IsRosName(text.substr(kind.size() + 1))) return false;
  process.ready = readiness;
  process.ready_name = text.substr(kind.size() + 1);
  return true;
}

}  // namespace

RestartLimits ReadRestartLimits(YamlFields fields, const RestartLimits& otherwise) {
  RestartLimits limits;
  limits.restarts = fields.Integer("restarts", otherwise.restarts, 0, 1000);
  limits.window = fields.Seconds("window", ToSeconds(otherwise.window), 1, 3600);
  limits.floor = fields.Seconds("floor", ToSeconds(otherwise.floor), 0, 3600);
  limits.healthy_after =
      fields.Seconds("healthy_after", ToSeconds(otherwise.healthy_after), 0, 86400);
  limits.hourly = fields.Integer("hourly", otherwise.hourly, 0, 10000);
  fields.Finish();
  return limits;
}

BackOff ReadBackOff(YamlFields fields) {
  BackOff back_off;
  back_off.first = fields.Seconds("first", ToSeconds(back_off.first), 0.01, 3600);
  back_off.most = fields.Seconds("most", ToSeconds(back_off.most), 0.01, 3600);
  fields.Finish();
  return back_off;
}

EscalationLimits ReadEscalation(YamlFields fields) {
  EscalationLimits limits;
  limits.closure = fields.Integer("closure", limits.closure, 0, 100);
  limits.stack = fields.Integer("stack", limits.stack, 0, 100);
  limits.ask_within = fields.Seconds("ask_within", ToSeconds(limits.ask_within), 1, 86400);
  fields.Finish();
  return limits;
}

Strategy ReadStrategy(YamlFields& group) {
  const std::string strategy =
      group.Choice("strategy", "one_for_one", {"one_for_one", "rest_for_one", "one_for_all"});
  if (strategy == "rest_for_one") return Strategy::kRestForOne;
  if (strategy == "one_for_all") return Strategy::kOneForAll;
  return Strategy::kOneForOne;
}

RestartRule ReadRestartRule(YamlFields& process) {
  const std::string rule = process.Choice("restart", "always", {"always", "on_failure", "never"});
  if (rule == "on_failure") return RestartRule::kOnFailure;
  if (rule == "never") return RestartRule::kNever;
  return RestartRule::kAlways;
}

HeartbeatConfig ReadHeartbeat(YamlFields fields) {
  HeartbeatConfig heartbeat;
  const LocatedText topic = fields.Text("topic");
  heartbeat.topic = topic.text;
  ExpectRosName(fields, "topic", topic);
  heartbeat.timeout = fields.Seconds("timeout", ToSeconds(heartbeat.timeout), 0.1, 3600);
  fields.Finish();
  return heartbeat;
}

void ReadReadiness(YamlFields& fields, ProcessConfig& process) {
  const LocatedText ready = fields.Text("ready", process.node.empty() ? "none" : "node");
  if (ready.text == "none") {
    process.ready = Readiness::kNone;
  } else if (ready.text == "node") {
    process.ready = Readiness::kNode;
  } else if (!ReadNamed(ready.text, "topic", Readiness::kTopic, process) &&
             !ReadNamed(ready.text, "service", Readiness::kService, process)) {
    fields.Error(
        ready.where,
        "\"ready\": \"" + ready.text + "\" is none of node, none, topic /NAME, service /NAME",
        DidYouMean(ready.text, {"node", "none"}));
  }
  if (process.ready != Readiness::kNone && process.node.empty()) {
    fields.Error(ready.where, "\"ready\": " + ready.text + " needs \"node\"");
  }
}

HostConfig ReadHost(const LocatedText& name, YamlFields fields) {
  HostConfig host;
  host.name = name.text;
  for (const LocatedText& word : fields.Texts("command")) host.command.push_back(word.text);
  if (host.command.empty()) fields.Error(name.where, "\"command\" is missing");
  host.shell = fields.Choice("shell", "yes", {"yes", "no"}) == "yes";
  host.bin = fields.Text("bin").text;
  host.address = fields.Text("address", "").text;
  fields.Finish();
  return host;
}

ConditionConfig ReadCondition(const LocatedText& name, YamlFields fields) {
  ConditionConfig condition;
  condition.name = name.text;
  const LocatedText topic = fields.Text("topic");
  condition.topic = topic.text;
  ExpectRosName(fields, "topic", topic);
  condition.current = fields.OptionalNumber("current", -1000, 1000);
  condition.lasting = fields.Seconds("lasting", 0, 0, 3600);
  condition.staleness = fields.Seconds("staleness", ToSeconds(condition.staleness), 0.01, 3600);
  fields.Finish();
  return condition;
}

}  // namespace coppice::robot::processes
