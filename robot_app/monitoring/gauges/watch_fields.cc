#include "robot_app/monitoring/gauges/watch_fields.h"

#include "robot_app/common/ros_name.h"
#include "robot_app/monitoring/gauges/band_fields.h"

namespace coppice::robot::monitoring {
namespace {

constexpr double kDay = 86400;
constexpr double kHour = 3600;

Content ReadContent(YamlFields& fields) {
  const std::string text = fields.Choice("content", "any", {"any", "laser_scan", "range"});
  if (text == "laser_scan") return Content::kLaserScan;
  return text == "range" ? Content::kRange : Content::kAny;
}

bool ReadOptional(YamlFields& fields) {
  return fields.Choice("optional", "no", {"yes", "no"}) == "yes";
}

}  // namespace

NodeWatch ReadNodeWatch(YamlFields& fields, int default_misses) {
  NodeWatch watch;
  watch.node = ReadRosName(fields, "node");
  watch.misses = fields.Integer("misses", default_misses, 1, 100);
  watch.is_optional = ReadOptional(fields);
  fields.Finish();
  return watch;
}

TopicWatch ReadTopicWatch(YamlFields& fields, double default_window) {
  TopicWatch watch;
  watch.topic = ReadRosName(fields, "topic");
  watch.node = ReadRosName(fields, "node");
  watch.kind = fields.Choice("kind", "topic", {"topic", "supervisor"});
  watch.by_statistics =
      fields.Choice("by", "subscriber", {"subscriber", "statistics"}) == "statistics";
  watch.is_optional = ReadOptional(fields);
  watch.content = ReadContent(fields);
  if (watch.content != Content::kAny && watch.by_statistics) {
    fields.Error(fields.where(), "\"content\" cannot be seen \"by: statistics\"");
  }
  Band otherwise;
  // The subscribers' statistics come in windows of their own, of several seconds.
  otherwise.staleness = std::chrono::seconds(watch.by_statistics ? 10 : 2);
  watch.band = ReadBandKeys(fields, otherwise);
  watch.window = fields.Seconds("window", default_window, 0.1, 600);
  watch.wall_time = fields.Choice("time", "ros", {"ros", "wall"}) == "wall";
  fields.Finish();
  return watch;
}

PublisherWatch ReadPublisherWatch(YamlFields& fields) {
  PublisherWatch watch;
  watch.topic = ReadRosName(fields, "topic");
  const std::vector<LocatedText> nodes = fields.Texts("nodes");
  if (nodes.empty()) fields.Error(fields.where(), "\"nodes\" names nobody");
  for (const LocatedText& node : nodes) {
    ExpectRosName(fields, "nodes", node);
    watch.nodes.push_back(node.text);
  }
  fields.Finish();
  return watch;
}

NavigationWatch ReadNavigationWatch(YamlFields& fields) {
  NavigationWatch watch;
  watch.topic = ReadRosName(fields, "topic");
  watch.node = ReadRosName(fields, "node");
  watch.blocked = fields.Seconds("blocked", 60, 0, kHour);
  watch.no_path = fields.Seconds("no_path", 60, 0, kHour);
  watch.staleness = fields.Seconds("staleness", 3, 0.01, kHour);
  watch.after_failure = fields.Seconds("after_failure", 15, 0, kHour);
  fields.Finish();
  return watch;
}

LocalizationWatch ReadLocalizationWatch(YamlFields& fields) {
  LocalizationWatch watch;
  watch.topic = ReadRosName(fields, "topic");
  watch.node = ReadRosName(fields, "node");
  watch.staleness = fields.Seconds("staleness", 3, 0.01, kHour);
  watch.since_confirmed = ReadBand(fields, "since_confirmed", AtMost(10, 20));
  // Whether the robot is lost, the localization knows best.
  watch.score = ReadBand(fields, "score", {{0.3, std::nullopt}, {}, 3, Duration::zero(), 0});
  watch.deviation =
      ReadBand(fields, "deviation", {{std::nullopt, 0.5}, {}, 3, Duration::zero(), 0});
  fields.Finish();
  return watch;
}

TransformWatch ReadTransformWatch(YamlFields& fields) {
  TransformWatch watch;
  watch.parent = fields.Text("parent").text;
  watch.child = fields.Text("child").text;
  watch.node = ReadRosName(fields, "node", "");
  Band age = AtMost(0.5, 1);
  age.staleness = std::chrono::seconds(3);
  watch.age = ReadBand(fields, "age", age);
  watch.jump = ReadBand(fields, "jump");
  watch.speed = fields.Number("speed", 0, 0, 1000);
  fields.Finish();
  return watch;
}

LoggerWatch ReadLoggerWatch(YamlFields& fields) {
  LoggerWatch watch;
  watch.name = fields.Text("name").text;
  watch.path = fields.Text("path", "").text;
  watch.topic = ReadRosName(fields, "topic", "");
  watch.node = ReadRosName(fields, "node", "");
  watch.staleness = fields.Seconds("staleness", 60, 0.1, kDay);
  if (watch.path.empty() == watch.topic.empty()) {
    fields.Error(fields.where(), "expected either \"path\" or \"topic\"");
  }
  fields.Finish();
  return watch;
}

DiagnosticsWatch ReadDiagnosticsWatch(YamlFields& fields) {
  DiagnosticsWatch watch;
  watch.staleness = fields.Seconds("staleness", 5, 0.1, kHour);
  fields.Finish();
  return watch;
}

SourceWatch ReadSourceWatch(YamlFields& fields) {
  SourceWatch watch;
  watch.source = ReadRosName(fields, "source");
  watch.period = fields.Seconds("period", 0.5, 0.01, kHour);
  watch.host = fields.Text("host", "").text;
  fields.Finish();
  return watch;
}

}  // namespace coppice::robot::monitoring
