#include <iostream>
#include <map>
#include <optional>

#include "bt_core/analysis/load_recording.h"
#include "bt_core/analysis/statistics.h"
#include "bt_core/base/command_line.h"
#include "bt_core/cli/replay/replay.h"

namespace coppice {
namespace {

constexpr char kUsage[] =
    "coppice stats FILE [--sort tree|ticks|time|flips] [--json]\n"
    "  What the nodes of a recorded run did, in figures: ticks, results, activations that took\n"
    "  more than one tick with their durations (p50, p95, max), changes of the result per minute,\n"
    "  first and last tick.";

}  // namespace

int RunStats(const std::vector<std::string>& arguments) {
  const std::map<std::string, StatisticsOrder> orders = {{"tree", StatisticsOrder::kTree},
                                                         {"ticks", StatisticsOrder::kTicks},
                                                         {"time", StatisticsOrder::kTime},
                                                         {"flips", StatisticsOrder::kFlips}};
  const std::optional<Options> options = ParseOptions(arguments, {"--sort"}, {"--json"}, kUsage);
  if (!options) return 2;
  const auto order = orders.find(options->Get("--sort", "tree"));
  if (options->files.size() != 1 || order == orders.end()) {
    std::cerr << "usage: " << kUsage << "\n";
    return 2;
  }
  Diagnostics diagnostics;
  const std::optional<Recording> run = LoadRecording(options->files[0], diagnostics);
  std::cerr << diagnostics.ToString();
  if (!run) return 2;
  const Statistics statistics = StatisticsOf(*run);
  std::cout << (options->Has("--json") ? StatisticsToJson(statistics, order->second) + "\n"
                                       : PrintStatistics(statistics, order->second));
  return 0;
}

}  // namespace coppice
