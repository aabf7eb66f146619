#include "robot_app/deployment/robot/watchers.h"

#include <algorithm>
#include <limits>

#include "robot_app/deployment/robot/senses.h"

namespace coppice::robot::deployment {
namespace {

using monitoring::Content;
using monitoring::Finding;
using monitoring::Monitor;
using monitoring::Times;
using monitoring::TopicWatch;

// The topic that falls silent or slows down when a program's rate is bad.
constexpr char kFaultyTopic[] = "/scan";
// Messages within this count for some rate.
constexpr double kWindow = 5;  // s

// Of the shipped robot's topics [Hz]; others come once a second.
double RateOf(const std::string& topic) {
  static const std::map<std::string, double> kRates = {
      {"/scan", 10},      {"/odom", 20},       {"/people", 10},     {"/clock", 10},
      {"/sonar/left", 5}, {"/sonar/front", 5}, {"/sonar/right", 5}, {"/battery_state", 2}};
  const auto found = kRates.find(topic);
  return found == kRates.end() ? 1 : found->second;
}

LaserScan UsableScan() {
  LaserScan scan;
  scan.ranges.assign(61, 3.0F);
  return scan;
}

}  // namespace

Watchers::Watchers(const monitoring::MonitorConfig& config, Watched watched, double lost_after)
    : config_(config),
      watched_(watched),
      lost_after_(lost_after),
      scan_(UsableScan()),
      topics_(config.patience),
      navigation_(config.patience),
      localization_(config.patience),
      battery_(config.patience),
      docking_(config.patience),
      emergency_stop_(config.patience) {
  ForgetReports();
}

void Watchers::ForgetReports() {
  aggregator_.emplace(config_.hold, config_.silent_periods);
  aggregator_->Expect(config_.ForConfiguration(configuration_).sources, watched_.world.now());
}

void Watchers::FollowConfiguration() {
  if (configuration_ == processes_.configuration) return;
  configuration_ = processes_.configuration;
  const monitoring::WatchList& list = config_.ForConfiguration(configuration_);
  const Times now{watched_.world.now(), watched_.world.now()};
  for (Monitor* monitor :
       {static_cast<Monitor*>(&nodes_), static_cast<Monitor*>(&topics_),
        static_cast<Monitor*>(&navigation_), static_cast<Monitor*>(&localization_),
        static_cast<Monitor*>(&battery_), static_cast<Monitor*>(&charging_),
        static_cast<Monitor*>(&docking_), static_cast<Monitor*>(&emergency_stop_)}) {
    monitor->Watch(list, now);
  }
  aggregator_->Expect(list.sources, now.wall);
}

void Watchers::FeedTopics(const Times& now) {
  const Time begin = looked_ ? std::max(*looked_, now.ros - Seconds(kWindow)) : now.ros;
  for (const TopicWatch& watch : config_.ForConfiguration(configuration_).topics) {
    const bool is_supervisors = watch.topic == "/processes";
    const double works = is_supervisors || watched_.programs.Works(watch.node) ? 1 : 0;
    const double share = watch.topic == kFaultyTopic ? watched_.programs.Rate(watch.node) : works;
    if (share <= 0) continue;
    const auto period = Seconds(1 / (share * RateOf(watch.topic)));
    // On a grid, so that the rate does not depend on when somebody looks.
    for (Time at = Time(begin.time_since_epoch() / period * period + period); at <= now.ros;
         at += period) {
      if (watch.content == Content::kLaserScan) {
        scan_.stamp = monitoring::InSeconds(at.time_since_epoch());
        topics_.OnScan(watch.topic, scan_, {at, at});
      } else if (watch.content == Content::kRange) {
        topics_.OnRange(watch.topic, std::numeric_limits<float>::infinity(),
                        monitoring::InSeconds(at.time_since_epoch()), {at, at});
      } else {
        topics_.OnMessage(watch.topic, {at, at});
      }
    }
  }
}

void Watchers::FeedStates(const Times& now) {
  const Programs& programs = watched_.programs;
  if (programs.Works("/navigation")) navigation_.OnState(watched_.drive.report(), now);
  if (programs.Works("/localization")) {
    localization_.OnState(watched_.position.reading(lost_after_), now);
  }
  if (programs.Works("/simulator")) {
    const leaves::BatteryReading reading = ReadBattery(watched_.world);
    battery_.OnReading(reading, now);
    charging_.OnReading(reading, now.ros);
    emergency_stop_.OnState(false, now);
  }
  battery_.OnDistance(watched_.ways.LengthHome(watched_.world.pose).value_or(0));
  if (programs.Works("/docking")) {
    const Station& station = watched_.station;
    docking_.OnGoals(station.goals(), now);
    if (station.is_busy()) {
      docking_.OnProgress(station.goals()[0].id, station.failed_attempts(), "it was not reached",
                          now.ros);
    }
  }
}

void Watchers::Report(const char* source, const std::vector<Monitor*>& monitors, const Times& now) {
  if (!watched_.programs.Works(source)) return;
  std::vector<Finding> all;
  for (Monitor* monitor : monitors) {
    for (Finding& finding : monitor->Report(processes_, now)) all.push_back(std::move(finding));
  }
  aggregator_->OnReport(source, all, now.wall);
}

std::optional<leaves::Health> Watchers::Look() {
  const Times now{watched_.world.now(), watched_.world.now()};
  processes_ = watched_.programs.Table();
  FollowConfiguration();
  FeedTopics(now);
  FeedStates(now);
  for (const std::string& node : watched_.programs.nodes()) {
    const bool answers = watched_.programs.Works(node);
    ProbeResult result;
    result.answered = answers;
    if (!answers) result.reason = "no answer";
    nodes_.Observe(node, result);
  }
  looked_ = now.ros;
  has_changed_ = false;
  if (!watched_.programs.Works("/health_aggregator")) return std::nullopt;
  Report("/node_monitor", {&nodes_}, now);
  Report("/topic_monitor", {&topics_}, now);
  Report("/navigation_monitor", {&navigation_, &localization_}, now);
  Report("/power_monitor", {&battery_, &charging_, &docking_, &emergency_stop_}, now);
  Report("/system_monitor", {}, now);
  aggregator_->CheckSilence(processes_, now.wall, now.ros);
  return Publish(now);
}

leaves::Health Watchers::Publish(const Times& now) {
  leaves::Health health;
  health.stamp = now.ros;
  std::string levels;
  sees_trouble_ = false;
  for (Finding& finding : aggregator_->Publish(now.wall, now.ros)) {
    levels += static_cast<char>('0' + static_cast<int>(finding.level));
    sees_trouble_ = sees_trouble_ || finding.level != leaves::HealthLevel::kOk;
    health.entries.push_back({std::move(finding.monitor), std::move(finding.subject),
                              std::move(finding.node), finding.level, std::move(finding.message)});
  }
  has_changed_ = levels != levels_;
  levels_ = std::move(levels);
  return health;
}

}  // namespace coppice::robot::deployment
