#include "robot_app/monitoring/topic_monitor.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace coppice::robot {
namespace {

constexpr std::size_t kMostMessages = 20000;  // a limit for a publisher gone wild

std::string Print(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", number);
  return text;
}

double InSeconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

bool Outside(const RateBand& band, double rate) {
  return (band.low && rate < *band.low) || (band.high && rate > *band.high);
}

std::string Print(const RateBand& band) {
  return (band.low ? Print(*band.low) : "0") + " to " + (band.high ? Print(*band.high) : "any") +
         " Hz";
}

}  // namespace

void RateWatch::Reset() {
  since_.reset();
  messages_.clear();
}

void RateWatch::Continue(const RateWatch& other) {
  since_ = other.since_;
  messages_ = other.messages_;
}

void RateWatch::OnMessage(Time now) {
  messages_.push_back(now);
  if (messages_.size() > kMostMessages) messages_.pop_front();
}

Finding RateWatch::Assess(Time now) {
  if (since_ && (now < *since_ || (!messages_.empty() && now < messages_.back()))) Reset();
  if (!since_) since_ = now;
  while (messages_.size() > 1 && messages_.front() <= now - watch_.window) messages_.pop_front();

  Finding finding{"topic", watch_.topic, watch_.node, HealthLevel::kOk, 0, "Hz", "", now};
  const Time newest = messages_.empty() ? *since_ : std::max(messages_.back(), *since_);
  std::size_t count = messages_.size();
  if (count == 1 && messages_.front() <= now - watch_.window) count = 0;
  finding.value = static_cast<double>(count) / InSeconds(watch_.window);
  if (now - newest > watch_.staleness) {
    finding.level = HealthLevel::kError;
    finding.message = "no message for " + Print(InSeconds(now - newest)) + " s";
  } else if (now - *since_ >= watch_.window) {
    Judge(finding.value, finding);
  } else {
    finding.message = "measuring";
  }
  return finding;
}

void RateWatch::Judge(double rate, Finding& finding) const {
  const bool is_error = Outside(watch_.error, rate);
  if (!is_error && !Outside(watch_.warn, rate)) return;
  finding.level = is_error ? HealthLevel::kError : HealthLevel::kWarn;
  finding.message = Print(rate) + " Hz, expected " + Print(is_error ? watch_.error : watch_.warn);
}

void TopicMonitor::Watch(const std::vector<TopicWatch>& topics) {
  std::vector<Watched> watched;
  for (const TopicWatch& topic : topics) {
    Watched entry{RateWatch(topic), Patience()};
    for (const Watched& known : topics_) {
      const TopicWatch& before = known.rate.watch();
      const bool same = before.topic == topic.topic && before.window == topic.window &&
                        before.wall_time == topic.wall_time;
      if (same) entry.rate.Continue(known.rate);
    }
    watched.push_back(std::move(entry));
  }
  topics_ = std::move(watched);
}

void TopicMonitor::OnMessage(const std::string& topic, const Times& now) {
  for (Watched& entry : topics_) {
    const TopicWatch& watch = entry.rate.watch();
    if (watch.topic == topic) entry.rate.OnMessage(watch.wall_time ? now.wall : now.ros);
  }
}

std::vector<Finding> TopicMonitor::Report(const ProcessTable& processes, const Times& now) {
  std::vector<Finding> findings;
  for (Watched& entry : topics_) {
    const TopicWatch& watch = entry.rate.watch();
    if (processes.IsStarting(watch.node)) entry.rate.Reset();
    Finding finding = entry.rate.Assess(watch.wall_time ? now.wall : now.ros);
    finding.stamp = now.ros;
    entry.patience.Apply(finding, now.wall, patience_);
    ApplyGrace(processes, watch.node, finding);
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace coppice::robot
