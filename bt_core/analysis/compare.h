// Where two runs of a tree part: the first tick in which they do something else, and what each node
// did differently. Ticks are aligned by their number since the beginning of each run, nodes by
// their path, so the two trees may differ.
#ifndef COPPICE_BT_CORE_ANALYSIS_COMPARE_H_
#define COPPICE_BT_CORE_ANALYSIS_COMPARE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/analysis/recording.h"

namespace coppice {

/// What one node or key did otherwise.
struct RunDifference {
  std::string what;              ///< path of the node, or "scope{key}"
  std::uint64_t ticks = 0;       ///< in which the two runs differ in it
  std::uint64_t first_tick = 0;  ///< the first of these, in the first run
  std::string first;             ///< what happened there in each run: "SUCCESS", "RUNNING RUNNING"
  std::string second;
};

/// The first event at which two runs part.
struct PartingPoint {
  std::uint64_t tick = 0;         ///< number in the first run
  std::uint64_t second_tick = 0;  ///< in the second
  Duration time{0};               ///< since the start of each run
  Duration second_time{0};
  std::string what;         ///< path of the node or key
  std::string second_what;  ///< of the second run, if it did something with another one
  std::string first;        ///< as in RunDifference, or "nothing more"
  std::string second;
};

struct RunComparison {
  std::uint64_t ticks = 0;        ///< that both runs have
  std::uint64_t first_ticks = 0;  ///< of each run
  std::uint64_t second_ticks = 0;
  std::uint64_t different_ticks = 0;
  std::optional<PartingPoint> parting;
  std::vector<RunDifference> differences;  ///< nodes in order of the first tree, then keys
  std::vector<std::string> only_first;     ///< paths of nodes that the other tree does not have
  std::vector<std::string> only_second;

  bool is_the_same() const {
    return !parting && first_ticks == second_ticks && only_first.empty() && only_second.empty();
  }
};

/// Of the first tree of each run; compares results, writes and deliveries, not times and messages.
RunComparison CompareRuns(const Recording& first, const Recording& second);

std::string PrintComparison(const RunComparison& comparison);
std::string ComparisonToJson(const RunComparison& comparison);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_COMPARE_H_
