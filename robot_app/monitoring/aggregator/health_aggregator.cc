#include "robot_app/monitoring/aggregator/health_aggregator.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace coppice::robot::monitoring {
namespace {

constexpr Duration kPeriodOfUnknownSources = std::chrono::seconds(2);
constexpr Duration kTimeToEnd = std::chrono::seconds(10);
constexpr Duration kUntilForgotten = std::chrono::seconds(60);

bool SameSubject(const Finding& a, const Finding& b) {
  return a.monitor == b.monitor && a.subject == b.subject;
}

}  // namespace

HealthAggregator::Source& HealthAggregator::Get(const std::string& name, Time now) {
  for (Source& source : sources_) {
    if (source.name == name) return source;
  }
  Source source;
  source.name = name;
  source.period = kPeriodOfUnknownSources;
  source.last_report = now;
  sources_.push_back(std::move(source));
  return sources_.back();
}

void HealthAggregator::Expect(const std::vector<SourceWatch>& sources, Time now) {
  const auto is_expected = [&sources](const std::string& name) {
    return std::any_of(sources.begin(), sources.end(),
                       [&name](const SourceWatch& watch) { return watch.source == name; });
  };
  for (Source& source : sources_) {
    if (!source.expected || is_expected(source.name)) continue;
    source.expected = false;
    source.dismissed_at = now;
    source.entries.clear();
    source.silent = false;
  }
  for (const SourceWatch& watch : sources) {
    Source& source = Get(watch.source, now);
    if (!source.expected) source.last_report = now;
    source.expected = true;
    source.dismissed_at.reset();
    source.period = watch.period;
    source.host = watch.host;
  }
}

bool HealthAggregator::Update(Entry& entry, const Finding& finding, Time now) {
  entry.current = finding;
  if (finding.level >= entry.worst.level) {
    entry.worst = finding;
    entry.worst_at = now;
    entry.worst_is_new = true;
  }
  return !entry.is_published || finding.level != entry.published;
}

bool HealthAggregator::OnReport(const std::string& name, const std::vector<Finding>& findings,
                                Time now) {
  Source& source = Get(name, now);
  if (source.dismissed_at && now - *source.dismissed_at < kTimeToEnd) return false;
  source.dismissed_at.reset();
  source.last_report = now;
  source.silent = false;
  bool changed = source.entries.size() != findings.size();
  std::vector<Entry> entries;
  for (const Finding& finding : findings) {
    const auto known =
        std::find_if(source.entries.begin(), source.entries.end(),
                     [&finding](const Entry& e) { return SameSubject(e.current, finding); });
    Entry entry = known == source.entries.end() ? Entry() : *known;
    changed = Update(entry, finding, now) || changed;
    entries.push_back(std::move(entry));
  }
  source.entries = std::move(entries);
  return changed;
}

bool HealthAggregator::CheckSilence(const ProcessTable& processes, Time now, Time stamp) {
  bool changed = false;
  ForgetStrangers(now);
  for (Source& source : sources_) {
    if (source.dismissed_at) continue;
    if (processes.IsStarting(source.name)) {
      changed = changed || source.silent;
      if (source.silent) source.entries.clear();
      source.silent = false;
      source.last_report = now;
      continue;
    }
    if (now - source.last_report <= silent_periods_ * source.period) continue;
    changed = changed || !source.silent;
    MakeStale(source, now, stamp);
  }
  return changed;
}

void HealthAggregator::ForgetStrangers(Time now) {
  const auto is_gone = [now](const Source& source) {
    return !source.expected && now - source.last_report > kUntilForgotten;
  };
  sources_.erase(std::remove_if(sources_.begin(), sources_.end(), is_gone), sources_.end());
}

void HealthAggregator::MakeStale(Source& source, Time now, Time stamp) {
  char silence[64];
  std::snprintf(silence, sizeof(silence), "no report for %.1f s",
                std::chrono::duration<double>(now - source.last_report).count());
  if (!source.silent) {
    Entry itself;
    itself.current.monitor = "node";
    itself.current.subject = source.name;
    itself.current.unit = "s";
    itself.current.host = source.host;
    source.entries.push_back(std::move(itself));
    source.silent = true;
  }
  for (Entry& entry : source.entries) {
    Finding stale = entry.current;
    stale.node = source.expected ? source.name : "";
    stale.level = leaves::HealthLevel::kStale;
    stale.message = source.name + ": " + silence;
    stale.stamp = stamp;
    Update(entry, stale, now);
  }
  Finding& itself = source.entries.back().current;
  itself.value = std::chrono::duration<double>(now - source.last_report).count();
}

std::vector<Finding> HealthAggregator::Publish(Time now, Time stamp) {
  std::vector<Finding> findings;
  for (Source& source : sources_) {
    for (Entry& entry : source.entries) {
      const bool show_worst = entry.worst.level > entry.current.level &&
                              (entry.worst_is_new || now < entry.worst_at + hold_);
      if (!show_worst) entry.worst = entry.current;
      findings.push_back(show_worst ? entry.worst : entry.current);
      entry.worst_is_new = false;
      entry.is_published = true;
      entry.published = findings.back().level;
    }
    if (source.expected || source.dismissed_at) continue;
    findings.push_back({"aggregation", source.name, "", leaves::HealthLevel::kWarn, 0, "",
                        "unknown source: not expected in this configuration", stamp, ""});
  }
  return findings;
}

}  // namespace coppice::robot::monitoring
