#include "robot_app/metrics/tree_metrics.h"

#include "bt_core/engine/events/for_each_event.h"
#include "bt_core/engine/program.h"

namespace coppice::robot::metrics {
namespace {

constexpr const char* kResultNames[] = {"success", "failure"};

}  // namespace

// Counters must not go back when a tree is changed while it runs.
void TreeMetrics::KeepResults() {
  for (std::uint32_t i = 0; program_ && i < results_.size(); ++i) {
    Results& older = older_[program_->Path(NodeIndex(i))];
    for (std::size_t k = 0; k < older.size(); ++k) older[k] += results_[i][k];
  }
  results_.clear();
}

void TreeMetrics::OnState(const StreamState& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  lost_ += state.lost_ticks;
  if (state.program == program_) return;
  KeepResults();
  program_ = state.program;
  results_.assign(program_->nodes.size(), {});
}

void TreeMetrics::OnTick(const TickEvents& events) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (events.result != Status::kIdle && events.is_whole) {
    ++ticks_;
    durations_.Add(std::chrono::duration<double>(events.duration).count());
  }
  ForEachEvent(
      events.words,
      [this](NodeIndex node, Status status) {
        const auto number = static_cast<std::uint32_t>(node);
        if (number >= results_.size()) return;
        if (status == Status::kSuccess) ++results_[number][0];
        if (status == Status::kFailure) ++results_[number][1];
      },
      [](const Event&) {});
}

void TreeMetrics::Collect(MetricTable& table) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Labels tree{{"tree", tree_}};
  table.Counter("coppice_ticks_total", "ticks of a tree", tree, static_cast<double>(ticks_));
  table.Counter("coppice_lost_ticks_total", "ticks whose events nobody could keep up with", tree,
                static_cast<double>(lost_));
  table.Histogram("coppice_tick_seconds", "how long a tick took, in real time", tree, durations_);
  std::map<std::string, Results> all = older_;
  for (std::uint32_t i = 0; program_ && i < results_.size(); ++i) {
    Results& results = all[program_->Path(NodeIndex(i))];
    for (std::size_t k = 0; k < results.size(); ++k) results[k] += results_[i][k];
  }
  for (const auto& [path, results] : all) {
    for (std::size_t k = 0; k < results.size(); ++k) {
      table.Counter("coppice_node_results_total", "how often a node returned SUCCESS or FAILURE",
                    {{"tree", tree_}, {"node", path}, {"result", kResultNames[k]}},
                    static_cast<double>(results[k]));
    }
  }
}

}  // namespace coppice::robot::metrics
