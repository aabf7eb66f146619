#include "robot_app/monitoring/monitor_config.h"

#include <algorithm>
#include <set>

#include "robot_app/supervision/yaml_fields.h"

namespace coppice::robot {
namespace {

constexpr double kHighestRate = 10000;

// A ROS name that must begin with a slash.
std::string RosName(YamlFields& fields, const std::string& key) {
  const LocatedText name = fields.Text(key);
  if (!name.text.empty() && name.text.front() != '/') {
    fields.Error(name.where,
                 "\"" + key + "\": expected a ROS name with slash, got \"" + name.text + "\"");
  }
  return name.text;
}

// "[low, high]", each a number or "none".
RateBand ReadBand(YamlFields& fields, const std::string& key) {
  RateBand band;
  if (!fields.Has(key)) {
    fields.Texts(key);
    return band;
  }
  const std::vector<LocatedText> bounds = fields.Texts(key);
  const auto read = [&fields, &key](const LocatedText& bound, std::optional<double>& rate) {
    if (bound.text == "none") return;
    double number = -1;
    if (YAML::convert<double>::decode(YAML::Node(bound.text), number) && number >= 0 &&
        number <= kHighestRate) {
      rate = number;
    } else {
      fields.Error(bound.where,
                   "\"" + key + "\": expected a rate in Hz or none, got \"" + bound.text + "\"");
    }
  };
  if (bounds.size() != 2) {
    fields.Error(fields.where(), "\"" + key + "\": expected [low, high]");
    return band;
  }
  read(bounds[0], band.low);
  read(bounds[1], band.high);
  if (band.low && band.high && *band.low >= *band.high) {
    fields.Error(bounds[0].where, "\"" + key + "\": low is not below high");
  }
  return band;
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
    YamlFields aggregator = file_.Map("health_aggregator");
    config_.publish_period = aggregator.Seconds("period", 0.25, 0.05, 60);
    config_.hold = aggregator.Seconds("hold", 0.25, 0, 60);
    config_.silent_periods = aggregator.Integer("silent_periods", 3, 1, 1000);
    aggregator.Finish();
    for (auto& [name, node] : file_.Pairs("configurations")) {
      YamlFields fields = file_.MapOf(node);
      ReadList(name.text, fields);
    }
    ReadInitial();
    file_.Finish();
    return std::move(config_);
  }

 private:
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
    for (YamlFields& item : fields.Maps("nodes")) list.nodes.push_back(ReadNode(item));
    for (YamlFields& item : fields.Maps("topics")) list.topics.push_back(ReadTopic(item));
    for (YamlFields& item : fields.Maps("sources")) list.sources.push_back(ReadSource(item));
    const bool has_navigation = fields.Has("navigation");
    YamlFields navigation = fields.Map("navigation");
    if (has_navigation) list.navigation = ReadNavigation(navigation);
    fields.Finish();
    Unique(fields, list.nodes, &NodeWatch::node);
    Unique(fields, list.topics, &TopicWatch::topic);
    Unique(fields, list.sources, &SourceWatch::source);
    config_.lists.push_back(std::move(list));
  }

  template <class Watch>
  static void Unique(const YamlFields& fields, const std::vector<Watch>& watches,
                     std::string Watch::*name) {
    std::set<std::string> seen;
    for (const Watch& watch : watches) {
      if (seen.insert(watch.*name).second) continue;
      fields.Error(fields.where(), "\"" + watch.*name + "\" is listed twice");
    }
  }

  NodeWatch ReadNode(YamlFields& fields) const {
    NodeWatch watch;
    watch.node = RosName(fields, "node");
    watch.misses = fields.Integer("misses", misses_, 1, 100);
    fields.Finish();
    return watch;
  }

  TopicWatch ReadTopic(YamlFields& fields) const {
    TopicWatch watch;
    watch.topic = RosName(fields, "topic");
    watch.node = RosName(fields, "node");
    watch.warn = ReadBand(fields, "warn");
    watch.error = ReadBand(fields, "error");
    watch.window = fields.Seconds("window", window_, 0.1, 600);
    watch.staleness = fields.Seconds("staleness", 2, 0.01, 86400);
    watch.wall_time = fields.Choice("time", "ros", {"ros", "wall"}) == "wall";
    const bool inverted =
        (watch.warn.low && watch.error.low && *watch.warn.low < *watch.error.low) ||
        (watch.warn.high && watch.error.high && *watch.warn.high > *watch.error.high);
    if (inverted) fields.Error(fields.where(), "\"warn\" is not within \"error\"");
    fields.Finish();
    return watch;
  }

  static SourceWatch ReadSource(YamlFields& fields) {
    SourceWatch watch;
    watch.source = RosName(fields, "source");
    watch.period = fields.Seconds("period", 0.5, 0.01, 3600);
    fields.Finish();
    return watch;
  }

  static NavigationWatch ReadNavigation(YamlFields& fields) {
    NavigationWatch watch;
    watch.topic = RosName(fields, "topic");
    watch.node = RosName(fields, "node");
    watch.blocked = fields.Seconds("blocked", 20, 0, 3600);
    watch.no_path = fields.Seconds("no_path", 5, 0, 3600);
    watch.staleness = fields.Seconds("staleness", 3, 0.01, 3600);
    watch.after_failure = fields.Seconds("after_failure", 15, 0, 3600);
    fields.Finish();
    return watch;
  }

  YamlFields file_;
  bool readable_;
  MonitorConfig config_;
  int misses_ = 2;
  double window_ = 2;
};

}  // namespace

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

}  // namespace coppice::robot
