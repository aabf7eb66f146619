#include <iostream>
#include <map>
#include <optional>

#include "bt_core/analysis/load_recording.h"
#include "bt_core/analysis/statistics.h"
#include "bt_core/base/command_line.h"
#include "bt_core/cli/plain_output.h"
#include "bt_core/cli/replay/replay.h"

namespace coppice {

const Command& StatsCommand() {
  static const Command command{
      "coppice stats",
      "figures of a recorded run, per node",
      {"FILE", 1, 1},
      R"(What the nodes of a recorded run did, in figures: ticks, results, activations that
took more than one tick with their durations (p50, p95, max), changes of the result per
minute, first and last tick.)",
      {CommandOption::OneOf("--sort", {"tree", "ticks", "time", "flips"}, "by what; else by tree"),
       CommandOption::Flag("--json", "as one JSON object"), MemoryOption()}};
  return command;
}

int RunStats(const std::vector<std::string>& arguments) {
  const std::map<std::string, StatisticsOrder> orders = {{"tree", StatisticsOrder::kTree},
                                                         {"ticks", StatisticsOrder::kTicks},
                                                         {"time", StatisticsOrder::kTime},
                                                         {"flips", StatisticsOrder::kFlips}};
  const Options options = ParseOptions(StatsCommand(), arguments);
  if (options.exit) return *options.exit;
  const StatisticsOrder order = orders.at(options.Get("--sort", "tree"));
  Diagnostics diagnostics;
  const std::optional<Recording> run =
      LoadRecording(options.files[0], diagnostics, MemoryOf(options));
  std::cerr << diagnostics.ToString();
  if (!run) return 2;
  const Statistics statistics = StatisticsOf(*run);
  const PlainOutput output;
  std::cout << (options.Has("--json") ? StatisticsToJson(statistics, order) + "\n"
                                      : PrintStatistics(statistics, order));
  return 0;
}

}  // namespace coppice
