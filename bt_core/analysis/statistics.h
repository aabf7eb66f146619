// What the nodes of a run did, in figures: who is never ticked, who flaps, who takes long. The time
// in which the tree stood at a breakpoint or was paused is in none of the durations.
//
//   const Statistics statistics = StatisticsOf(recording);
//   std::cout << PrintStatistics(statistics, StatisticsOrder::kTree);
#ifndef COPPICE_BT_CORE_ANALYSIS_STATISTICS_H_
#define COPPICE_BT_CORE_ANALYSIS_STATISTICS_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/analysis/recording.h"

namespace coppice {

/// Of a set of durations; all 0 if it is empty.
struct Spread {
  std::uint64_t count = 0;
  Duration p50{0};
  Duration p95{0};
  Duration p99{0};
  Duration max{0};
};

/// The p-quantiles are the smallest durations that at least p of all are not above. Sorts its copy.
Spread SpreadOf(std::vector<Duration> durations);

struct NodeStatistics {
  std::string path;
  std::string id;
  std::uint64_t ticks = 0;                 ///< how often it was ticked
  std::array<std::uint64_t, 5> results{};  ///< of these, by Status; at IDLE: how often halted
  Spread activations;                      ///< from the first tick to SUCCESS, FAILURE or halt
  std::uint64_t flips = 0;                 ///< result unlike the last SUCCESS or FAILURE
  double flips_per_minute = 0;             ///< over the time of the run without its pauses
  std::uint64_t first_tick = 0;            ///< number of the first and the last tick; 0: never
  std::uint64_t last_tick = 0;

  std::uint64_t results_of(Status status) const {
    return results[static_cast<std::size_t>(status)];
  }
};

struct Statistics {
  std::uint64_t ticks = 0;
  Duration time{0};       ///< from the first tick to the last, in the tree's clock; with pauses
  Duration paused{0};     ///< of these, at breakpoints or paused
  Spread tick_durations;  ///< in real time
  Spread periods;         ///< from tick to tick, in the tree's clock
  std::uint64_t lost_ticks = 0;
  std::vector<NodeStatistics>
      nodes;  ///< in the order of the tree; of all trees of the run, by path
};

/// An activation that goes on at a gap or a jump is not counted.
Statistics StatisticsOf(const Recording& run);

enum class StatisticsOrder : std::uint8_t { kTree, kTicks, kTime, kFlips };

/// A table. Orders but kTree begin with the highest.
std::string PrintStatistics(const Statistics& statistics, StatisticsOrder order);
/// One JSON object in one line; times in seconds.
std::string StatisticsToJson(const Statistics& statistics, StatisticsOrder order);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_STATISTICS_H_
