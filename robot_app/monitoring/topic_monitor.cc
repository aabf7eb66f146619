#include "robot_app/monitoring/topic_monitor.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace coppice::robot::monitoring {
namespace {

constexpr std::size_t kMostMessages = 20000;  // a limit for a publisher gone wild
constexpr double kClockOff = 5;               // s; no transport takes so long

// What is wrong with the time of a measurement; empty: nothing.
std::string ProblemOfStamp(double stamp, Time now) {
  const double age = InSeconds(now.time_since_epoch()) - stamp;
  if (std::abs(age) <= kClockOff) return "";
  return "its stamp is " + ToText(std::abs(age)) + (age > 0 ? " s old" : " s ahead");
}

}  // namespace

void RateWatch::Reset() {
  judge_.Reset();
  since_.reset();
  messages_.clear();
  unusable_.clear();
}

void RateWatch::Continue(const RateWatch& other) {
  since_ = other.since_;
  messages_ = other.messages_;
  unusable_ = other.unusable_;
  if (watch_.band == other.watch_.band) judge_ = other.judge_;
}

void RateWatch::OnMessage(Time now) {
  unusable_.clear();
  messages_.push_back(now);
  if (messages_.size() > kMostMessages) messages_.pop_front();
}

Finding RateWatch::Assess(Time now) {
  if (since_ && (now < *since_ || (!messages_.empty() && now < messages_.back()))) Reset();
  if (!since_) since_ = now;
  while (messages_.size() > 1 && messages_.front() <= now - watch_.window) messages_.pop_front();

  Finding finding{"topic", watch_.topic, watch_.node, leaves::HealthLevel::kOk, 0, "Hz", "", now};
  const Time newest = messages_.empty() ? *since_ : std::max(messages_.back(), *since_);
  std::size_t count = messages_.size();
  if (count == 1 && messages_.front() <= now - watch_.window) count = 0;
  finding.value = static_cast<double>(count) / InSeconds(watch_.window);
  const Duration staleness = watch_.band.staleness;
  if (staleness > Duration::zero() && now - newest > staleness) {
    finding.level = leaves::HealthLevel::kError;
    finding.message = unusable_.empty() ? "no message for " : "no usable message for ";
    finding.message += ToText(InSeconds(now - newest)) + " s";
  } else if (now - *since_ >= watch_.window) {
    judge_.OnValue(finding.value, now);
    const Assessment assessment = judge_.Assess(now);
    finding.level = assessment.level;
    finding.message = assessment.message;
  } else {
    finding.message = "measuring";
  }
  if (!unusable_.empty()) finding.message += ": " + unusable_;
  return finding;
}

void TopicMonitor::Watch(const std::vector<TopicWatch>& topics) {
  std::vector<Watched> watched;
  for (const TopicWatch& topic : topics) {
    Watched entry{RateWatch(topic), StatisticsWatch(topic), Patience(), 0};
    for (const Watched& known : topics_) {
      const TopicWatch& before = known.rate.watch();
      const bool same = before.topic == topic.topic && before.window == topic.window &&
                        before.wall_time == topic.wall_time && before.content == topic.content;
      if (same) entry.rate.Continue(known.rate);
      if (same) entry.statistics.Continue(known.statistics);
      if (same) entry.pid = known.pid;
    }
    watched.push_back(std::move(entry));
  }
  topics_ = std::move(watched);
}

void TopicMonitor::OnMessage(const std::string& topic, const Times& now) {
  OnContent(topic, Content::kAny, "", now);
}

void TopicMonitor::OnScan(const std::string& topic, const LaserScan& scan, const Times& now) {
  const std::string problem =
      IsUsable(scan) ? ProblemOfStamp(scan.stamp, now.ros) : WhatTells(scan);
  OnContent(topic, Content::kLaserScan, problem, now);
}

void TopicMonitor::OnRange(const std::string& topic, float range, double stamp, const Times& now) {
  const bool is_blind = std::isnan(range);
  const std::string problem = is_blind ? "it tells no distance" : ProblemOfStamp(stamp, now.ros);
  OnContent(topic, Content::kRange, problem, now);
}

void TopicMonitor::OnContent(const std::string& topic, Content content, const std::string& problem,
                             const Times& now) {
  for (Watched& entry : topics_) {
    const TopicWatch& watch = entry.rate.watch();
    if (watch.topic != topic || watch.content != content) continue;
    if (problem.empty()) {
      entry.rate.OnMessage(watch.wall_time ? now.wall : now.ros);
    } else {
      entry.rate.OnUnusable(problem);
    }
  }
}

void TopicMonitor::OnStatistics(const SubscriberStatistics& statistics, const Times& now) {
  for (Watched& entry : topics_) {
    const TopicWatch& watch = entry.rate.watch();
    if (watch.topic != statistics.topic) continue;
    entry.statistics.OnStatistics(statistics, watch.wall_time ? now.wall : now.ros);
  }
}

Finding TopicMonitor::Assess(Watched& entry, const Times& now) {
  const TopicWatch& watch = entry.rate.watch();
  const Time time = watch.wall_time ? now.wall : now.ros;
  return watch.by_statistics ? entry.statistics.Assess(time) : entry.rate.Assess(time);
}

std::vector<Finding> TopicMonitor::Report(const ProcessTable& processes, const Times& now) {
  std::vector<Finding> findings;
  for (Watched& entry : topics_) {
    const TopicWatch& watch = entry.rate.watch();
    // A start may be shorter than the time between two reports.
    const int pid = processes.PidOf(watch.node);
    const bool is_off = watch.is_optional && processes.IsOff(watch.node);
    if (is_off || processes.IsStarting(watch.node) || pid != entry.pid) {
      entry.rate.Reset();
      entry.statistics.Reset();
    }
    entry.pid = pid;
    Finding finding = Assess(entry, now);
    finding.stamp = now.ros;
    finding.monitor = watch.kind;
    if (is_off) finding.level = leaves::HealthLevel::kOk;
    if (is_off) finding.message = kOff;
    entry.patience.Apply(finding, now.wall, patience_);
    ApplyGrace(processes, watch.node, finding);
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace coppice::robot::monitoring
