#include "robot_app/deployment/robot/controller.h"

#include <algorithm>

#include "robot_app/common/yaml_fields.h"
#include "robot_app/deployment/world/event_queue.h"

namespace coppice::robot::deployment {
namespace {

constexpr double kLong = 1e7;  // s
constexpr int kMany = 1'000'000;

bool YesOrNo(YamlFields& fields, const char* key, bool otherwise) {
  return fields.Choice(key, otherwise ? "yes" : "no", {"yes", "no"}) == "yes";
}

void ReadPretended(YamlFields& fields, Controller& controller) {
  for (YamlFields& entry : fields.Maps("pretend")) {
    Pretended pretended;
    pretended.tree = entry.Choice("tree", "application", {"application", "monitor"});
    pretended.node = entry.Text("node").text;
    const std::string result = entry.Choice("result", "SUCCESS", {"SUCCESS", "FAILURE", "RUNNING"});
    pretended.result = result == "FAILURE"   ? Status::kFailure
                       : result == "RUNNING" ? Status::kRunning
                                             : Status::kSuccess;
    entry.Finish();
    controller.pretended.push_back(pretended);
  }
}

void ReadPatience(YamlFields& fields, Controller& controller) {
  YamlFields navigation = fields.Map("navigation");
  controller.gives_up = navigation.Number("gives_up", controller.gives_up, 1, kLong);
  controller.navigation_error = navigation.Number("error", controller.navigation_error, 1, kLong);
  navigation.Finish();
  YamlFields localization = fields.Map("localization");
  controller.lost_after = localization.Number("lost", controller.lost_after, 0, kLong);
  controller.localization_error =
      localization.Number("error", controller.localization_error, 1, kLong);
  localization.Finish();
  YamlFields monitors = fields.Map("monitors");
  controller.monitor_period = monitors.Number("period", controller.monitor_period, 0.1, 60);
  controller.watches_topics = YesOrNo(monitors, "topics", controller.watches_topics);
  monitors.Finish();
}

Restarts RestartsOf(const std::string& name) {
  if (name == "endless") return Restarts::kEndless;
  return name == "by_monitors" ? Restarts::kByMonitors : Restarts::kByThemselves;
}

Controller Read(YamlFields& fields, const std::vector<Controller>& known) {
  Controller controller;
  const LocatedText like = fields.Text("like", "");
  const auto model = std::find_if(known.begin(), known.end(),
                                  [&](const Controller& c) { return c.name == like.text; });
  if (model != known.end()) controller = *model;
  if (model == known.end() && !like.text.empty()) {
    fields.Error(like.where, "there is no controller \"" + like.text + "\" further up");
  }
  controller.name = fields.Text("name").text;
  controller.says = fields.Text("says").text;
  controller.application = fields.Text("application", controller.application).text;
  controller.monitor = fields.Text("monitor", controller.monitor).text;
  ReadPretended(fields, controller);
  if (fields.Has("programs")) {
    controller.restarts = RestartsOf(
        fields.Choice("programs", "by_themselves", {"by_themselves", "endless", "by_monitors"}));
  }
  if (fields.Has("docking")) {
    controller.contact_is_success =
        fields.Choice("docking", "current", {"current", "contact"}) == "contact";
  }
  controller.plans_charging = YesOrNo(fields, "plans_charging", controller.plans_charging);
  if (fields.Has("asks")) {
    controller.asks_all = fields.Choice("asks", "everybody", {"everybody", "one"}) == "everybody";
  }
  ReadPatience(fields, controller);
  fields.Finish();
  return controller;
}

}  // namespace

std::vector<Controller> LoadControllers(const std::string& path, Diagnostics& diagnostics) {
  std::vector<Controller> controllers;
  YamlFields file = YamlFields::Load(path, diagnostics);
  for (YamlFields& fields : file.Maps("controllers")) {
    controllers.push_back(Read(fields, controllers));
  }
  file.Finish();
  return controllers;
}

processes::RobotConfig Changed(processes::RobotConfig config, const Controller& controller) {
  if (controller.restarts == Restarts::kByThemselves) return config;
  for (processes::GroupConfig& group : config.groups) {
    group.limits.restarts = group.limits.hourly = kMany;
    group.limits.floor = std::chrono::seconds(1);
  }
  config.back_off = {std::chrono::seconds(1), std::chrono::seconds(1)};
  config.escalation.ask_within = Seconds(kLong);
  if (controller.restarts == Restarts::kByMonitors) {
    for (processes::ProcessConfig& process : config.processes) {
      process.restart = processes::RestartRule::kNever;
    }
  }
  return config;
}

monitoring::MonitorConfig Changed(monitoring::MonitorConfig config, const Controller& controller) {
  config.report_period = Seconds(controller.monitor_period);
  for (monitoring::WatchList& list : config.lists) {
    for (monitoring::SourceWatch& source : list.sources) source.period = config.report_period;
    if (list.navigation) list.navigation->blocked = Seconds(controller.navigation_error);
    if (list.navigation) list.navigation->no_path = Seconds(controller.navigation_error);
    if (list.localization) {
      list.localization->since_confirmed =
          monitoring::AtMost(controller.localization_error / 2, controller.localization_error);
    }
    if (!controller.watches_topics) list.topics.clear();
  }
  return config;
}

}  // namespace coppice::robot::deployment
