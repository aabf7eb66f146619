// What a tree does, in figures: ticks, how long they take, and what its nodes return.
#ifndef COPPICE_ROBOT_APP_METRICS_TREE_METRICS_H_
#define COPPICE_ROBOT_APP_METRICS_TREE_METRICS_H_

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "bt_core/engine/events/event_stream.h"
#include "robot_app/metrics/metric_table.h"

namespace coppice::robot::metrics {

class TreeMetrics final : public EventListener {
 public:
  /// Added to the stream by who owns both. `tree`: its name in the figures.
  explicit TreeMetrics(std::string tree) : tree_(std::move(tree)) {}

  void OnState(const StreamState& state) override;
  void OnTick(const TickEvents& events) override;

  /// Any thread.
  void Collect(MetricTable& table) const;

 private:
  using Results = std::array<std::uint64_t, 2>;  // SUCCESS, FAILURE

  void KeepResults();

  const std::string tree_;
  mutable std::mutex mutex_;  // of the rest
  std::shared_ptr<const Program> program_;
  std::vector<Results> results_;          // by node of the program
  std::map<std::string, Results> older_;  // by path, of programs that the tree had before
  std::uint64_t ticks_ = 0;
  std::uint64_t lost_ = 0;
  DurationCounts durations_{{1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 1}};
};

}  // namespace coppice::robot::metrics

#endif  // COPPICE_ROBOT_APP_METRICS_TREE_METRICS_H_
