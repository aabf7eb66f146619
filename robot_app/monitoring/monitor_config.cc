#include "robot_app/monitoring/monitor_config.h"

#include <algorithm>

#include "robot_app/monitoring/gauges/band_fields.h"
#include "robot_app/monitoring/gauges/watch_fields.h"
#include "robot_app/monitoring/power/power_fields.h"
#include "robot_app/monitoring/system/system_fields.h"

namespace coppice::robot::monitoring {
namespace {

// The section `key` if there is one.
template <class Watch>
std::optional<Watch> Section(YamlFields& fields, const std::string& key,
                             Watch (*read)(YamlFields&)) {
  const bool is_given = fields.Has(key);
  YamlFields section = fields.Map(key);
  return is_given ? std::optional<Watch>(read(section)) : std::nullopt;
}

template <class Watch>
void CheckNames(const YamlFields& fields, const std::vector<Watch>& watches,
                std::string Watch::*name) {
  std::vector<std::string> names;
  for (const Watch& watch : watches) names.push_back(watch.*name);
  CheckUnique(fields, names);
}

class Loader {
 public:
  Loader(const std::string& path, Diagnostics& diagnostics)
      : file_(YamlFields::Load(path, diagnostics)), readable_(!diagnostics.has_errors()) {}

  MonitorConfig Load() {
    if (!readable_) return {};
    config_.report_period = file_.Seconds("report_period", 0.5, 0.05, 60);
    config_.patience = file_.Seconds("patience", 0.4, 0, 60);
    YamlFields nodes = file_.Map("node_monitor");
    config_.ping_deadline = nodes.Seconds("deadline", 0.5, 0.01, 60);
    misses_ = nodes.Integer("misses", 2, 1, 100);
    nodes.Finish();
    YamlFields topics = file_.Map("topic_monitor");
    window_ = topics.Number("window", 2, 0.1, 600);
    topics.Finish();
    ReadAggregator();
    for (YamlFields& item : file_.Maps("system")) config_.system.push_back(ReadSystemWatch(item));
    CheckNames(file_, config_.system, &SystemWatch::host);
    for (auto& [name, node] : file_.Pairs("configurations")) {
      YamlFields fields = file_.MapOf(node);
      ReadList(name.text, fields);
    }
    ReadInitial();
    file_.Finish();
    return std::move(config_);
  }

 private:
  void ReadAggregator() {
    YamlFields aggregator = file_.Map("health_aggregator");
    config_.publish_period = aggregator.Seconds("period", 0.25, 0.05, 60);
    config_.hold = aggregator.Seconds("hold", 0.25, 0, 60);
    config_.silent_periods = aggregator.Integer("silent_periods", 3, 1, 1000);
    config_.diagnostics_period = aggregator.Seconds("diagnostics", 1, 0, 60);
    aggregator.Finish();
  }

  void ReadInitial() {
    if (config_.lists.empty()) {
      file_.Error(file_.where(), "\"configurations\" names no configuration");
      return;
    }
    const LocatedText initial = file_.Text("initial", config_.lists.front().configuration);
    config_.initial = initial.text;
    std::vector<std::string> names;
    for (const WatchList& list : config_.lists) names.push_back(list.configuration);
    if (std::find(names.begin(), names.end(), initial.text) == names.end()) {
      file_.Error(initial.where, "unknown configuration \"" + initial.text + "\"",
                  DidYouMean(initial.text, names));
    }
  }

  void ReadList(const std::string& name, YamlFields& fields) {
    WatchList list;
    list.configuration = name;
    for (YamlFields& item : fields.Maps("nodes")) {
      list.nodes.push_back(ReadNodeWatch(item, misses_));
    }
    for (YamlFields& item : fields.Maps("topics")) {
      list.topics.push_back(ReadTopicWatch(item, window_));
    }
    for (YamlFields& item : fields.Maps("publishers")) {
      list.publishers.push_back(ReadPublisherWatch(item));
    }
    ReadMovement(fields, list);
    ReadPower(fields, list);
    for (YamlFields& item : fields.Maps("loggers")) list.loggers.push_back(ReadLoggerWatch(item));
    list.diagnostics = Section(fields, "diagnostics", &ReadDiagnosticsWatch);
    for (YamlFields& item : fields.Maps("sources")) list.sources.push_back(ReadSourceWatch(item));
    fields.Finish();
    CheckNames(fields, list.nodes, &NodeWatch::node);
    CheckNames(fields, list.topics, &TopicWatch::topic);
    CheckNames(fields, list.publishers, &PublisherWatch::topic);
    CheckNames(fields, list.loggers, &LoggerWatch::name);
    CheckNames(fields, list.sources, &SourceWatch::source);
    config_.lists.push_back(std::move(list));
  }

  static void ReadMovement(YamlFields& fields, WatchList& list) {
    list.navigation = Section(fields, "navigation", &ReadNavigationWatch);
    list.localization = Section(fields, "localization", &ReadLocalizationWatch);
    std::vector<std::string> pairs;
    for (YamlFields& item : fields.Maps("transforms")) {
      list.transforms.push_back(ReadTransformWatch(item));
      pairs.push_back(list.transforms.back().parent + " -> " + list.transforms.back().child);
    }
    CheckUnique(fields, pairs);
  }

  static void ReadPower(YamlFields& fields, WatchList& list) {
    list.battery = Section(fields, "battery", &ReadBatteryLimits);
    list.charging = Section(fields, "charging", &ReadChargingWatch);
    list.docking = Section(fields, "docking", &ReadDockingWatch);
    list.emergency_stop = Section(fields, "emergency_stop", &ReadEmergencyStopWatch);
    if (list.charging && !list.battery) {
      fields.Error(fields.where(), "\"charging\" needs \"battery\"");
    }
  }

  YamlFields file_;
  bool readable_;
  MonitorConfig config_;
  int misses_ = 2;
  double window_ = 2;
};

}  // namespace

const SystemWatch* MonitorConfig::ForHost(const std::string& host) const {
  const SystemWatch* found = nullptr;
  for (const SystemWatch& watch : system) {
    if (watch.host == host) return &watch;
    if (watch.host.empty()) found = &watch;
  }
  return found;
}

const WatchList& MonitorConfig::ForConfiguration(const std::string& name) const {
  static const WatchList kNothing;
  const auto found = std::find_if(lists.begin(), lists.end(), [&name](const WatchList& list) {
    return list.configuration == name;
  });
  return found == lists.end() ? kNothing : *found;
}

MonitorConfig LoadMonitorConfig(const std::string& path, Diagnostics& diagnostics) {
  return Loader(path, diagnostics).Load();
}

}  // namespace coppice::robot::monitoring
