#include "bt_core/analysis/statistics.h"

#include <algorithm>
#include <map>
#include <optional>

#include "bt_core/analysis/pauses.h"
#include "bt_core/frames/follower.h"

namespace coppice {
namespace {

// What is counted of one node while the run goes by.
struct Counter {
  NodeStatistics figures;
  std::optional<Time> active_since;
  std::vector<Duration> activations;
  Status last_completed = Status::kIdle;
};

class Count {
 public:
  explicit Count(const Recording& run) : run_(run), pauses_(run) {}

  Statistics Take() {
    const auto& sections = run_.sections();
    for (std::size_t i = 0; i < sections.size(); ++i) {
      const bool is_last = i + 1 == sections.size();
      CountSection(sections[i], is_last ? run_.ticks().size() : sections[i + 1].first_tick);
    }
    for (const Recording::Gap& gap : run_.gaps()) statistics_.lost_ticks += gap.gap.lost_ticks;
    Finish();
    return std::move(statistics_);
  }

 private:
  void CountSection(const Recording::Section& section, std::size_t end) {
    UseTree(section.tree);
    if (!FollowsOn(section)) {
      for (Counter& counter : counters_) counter.active_since.reset();
      last_start_.reset();
    }
    HistoryFollower follower(ShapeOf(run_.trees()[section.tree]), section.state);
    for (std::size_t i = section.first_tick; i < end; ++i) CountTick(run_.EventsOf(i), follower);
  }

  void UseTree(std::size_t tree) {
    if (tree_ == tree) return;
    tree_ = tree;
    numbers_.clear();
    for (const DescribedNode& node : run_.trees()[tree].nodes) {
      const auto [at, is_new] = by_path_.emplace(node.path, counters_.size());
      if (is_new) {
        counters_.emplace_back();
        counters_.back().figures.path = node.path;
        counters_.back().figures.id = node.id;
      }
      numbers_.push_back(at->second);
    }
  }

  void CountTick(const TickEvents& events, HistoryFollower& follower) {
    const bool is_tick = events.result != Status::kIdle;
    if (is_tick) {
      durations_.push_back(pauses_.RunIn(events));
      if (last_start_) periods_.push_back(pauses_.RunWithin(*last_start_, events.start));
      if (statistics_.ticks++ == 0) first_start_ = events.start;
      last_start_ = events.start;
    }
    newest_ = std::max(newest_, events.start);
    follower.Apply(
        events, [&](const StatusChange& change) { CountChange(change, events); },
        [&](const Event& event) { CountResult(event, events.tick); });
  }

  Counter& CounterOf(NodeIndex node) { return counters_[numbers_[node]]; }

  void CountResult(const Event& event, std::uint64_t tick) {
    if (!event.is_result()) return;
    Counter& counter = CounterOf(event.node());
    NodeStatistics& figures = counter.figures;
    ++figures.ticks;
    ++figures.results[static_cast<std::size_t>(event.status())];
    if (figures.first_tick == 0) figures.first_tick = tick;
    figures.last_tick = tick;
    if (!IsCompleted(event.status())) return;
    const bool flips =
        counter.last_completed != Status::kIdle && counter.last_completed != event.status();
    figures.flips += flips;
    counter.last_completed = event.status();
  }

  // An activation begins when a node leaves IDLE or runs again, and ends when it no longer runs.
  // What takes one tick only does not count.
  void CountChange(const StatusChange& change, const TickEvents& events) {
    Counter& counter = CounterOf(change.node);
    const bool is_halted = change.from == Status::kRunning && change.to == Status::kIdle;
    counter.figures.results[0] += is_halted;
    if (change.to == Status::kRunning) {
      counter.active_since = events.start;
    } else if (change.from == Status::kRunning && counter.active_since) {
      counter.activations.push_back(pauses_.RunWithin(*counter.active_since, events.start));
      counter.active_since.reset();
    }
  }

  void Finish() {
    if (statistics_.ticks > 0) {
      statistics_.time = newest_ - first_start_;
      statistics_.paused = pauses_.Within(first_start_, newest_);
    }
    statistics_.tick_durations = SpreadOf(std::move(durations_));
    statistics_.periods = SpreadOf(std::move(periods_));
    const Duration ran = statistics_.time - statistics_.paused;
    const double minutes = static_cast<double>(ran.count()) * 1e-9 / 60;
    for (Counter& counter : counters_) {
      counter.figures.activations = SpreadOf(std::move(counter.activations));
      if (minutes > 0) {
        counter.figures.flips_per_minute = static_cast<double>(counter.figures.flips) / minutes;
      }
      statistics_.nodes.push_back(std::move(counter.figures));
    }
  }

  const Recording& run_;
  const Pauses pauses_;
  Statistics statistics_;
  std::size_t tree_ = SIZE_MAX;
  std::vector<std::size_t> numbers_;  // of counters_, per node of the tree
  std::map<std::string, std::size_t> by_path_;
  std::vector<Counter> counters_;
  std::vector<Duration> durations_;
  std::vector<Duration> periods_;
  std::optional<Time> last_start_;
  Time first_start_{};
  Time newest_ = Time::min();
};

}  // namespace

Spread SpreadOf(std::vector<Duration> durations) {
  Spread spread;
  spread.count = durations.size();
  if (durations.empty()) return spread;
  std::sort(durations.begin(), durations.end());
  const auto quantile = [&](std::size_t percent) {
    return durations[(durations.size() * percent + 99) / 100 - 1];
  };
  spread.p50 = quantile(50);
  spread.p95 = quantile(95);
  spread.p99 = quantile(99);
  spread.max = durations.back();
  return spread;
}

Statistics StatisticsOf(const Recording& run) { return Count(run).Take(); }

}  // namespace coppice
