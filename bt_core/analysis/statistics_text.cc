#include <algorithm>
#include <cstdio>

#include "bt_core/analysis/statistics.h"
#include "bt_core/base/json.h"

namespace coppice {
namespace {

// Three digits and a unit: "1.24 ms".
std::string Print(Duration time) {
  constexpr struct {
    double size;
    const char* name;
  } kUnits[] = {{1e9, "s"}, {1e6, "ms"}, {1e3, "us"}, {1, "ns"}};
  if (time.count() == 0) return "0";
  const auto nanoseconds = static_cast<double>(time.count());
  for (const auto& unit : kUnits) {
    const double value = nanoseconds / unit.size;
    if (value < 1 && unit.size > 1) continue;
    char text[40];
    std::snprintf(text, sizeof text, "%.*f %s",
                  value < 10    ? 2
                  : value < 100 ? 1
                                : 0,
                  value, unit.name);
    return text;
  }
  return "0";
}

std::string Line(const std::vector<std::string>& cells) {
  static constexpr std::size_t kWidths[] = {8, 8, 8, 8, 8, 8, 8, 10, 10, 10, 9, 8, 8};
  std::string line;
  for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
    const std::size_t width = kWidths[i];
    line += std::string(cells[i].size() < width ? width - cells[i].size() : 1, ' ') + cells[i];
  }
  return line + "  " + cells.back() + "\n";
}

std::vector<std::string> CellsOf(const NodeStatistics& node) {
  char flips[32];
  std::snprintf(flips, sizeof flips, "%.1f", node.flips_per_minute);
  const bool is_timed = node.activations.count > 0;
  const auto time = [&](Duration duration) { return is_timed ? Print(duration) : "-"; };
  return {std::to_string(node.ticks),
          std::to_string(node.results_of(Status::kSuccess)),
          std::to_string(node.results_of(Status::kFailure)),
          std::to_string(node.results_of(Status::kRunning)),
          std::to_string(node.results_of(Status::kSkipped)),
          std::to_string(node.results_of(Status::kIdle)),
          std::to_string(node.activations.count),
          time(node.activations.p50),
          time(node.activations.p95),
          time(node.activations.max),
          flips,
          node.ticks > 0 ? std::to_string(node.first_tick) : "never",
          node.ticks > 0 ? std::to_string(node.last_tick) : "never",
          node.path};
}

std::vector<const NodeStatistics*> Sorted(const Statistics& statistics, StatisticsOrder order) {
  std::vector<const NodeStatistics*> nodes;
  for (const NodeStatistics& node : statistics.nodes) nodes.push_back(&node);
  const auto by = [&](auto key) {
    std::stable_sort(nodes.begin(), nodes.end(),
                     [&](const auto* a, const auto* b) { return key(*a) > key(*b); });
  };
  if (order == StatisticsOrder::kTicks) by([](const auto& node) { return node.ticks; });
  if (order == StatisticsOrder::kTime) by([](const auto& node) { return node.activations.p95; });
  if (order == StatisticsOrder::kFlips) by([](const auto& node) { return node.flips; });
  return nodes;
}

std::string Print(const char* name, const Spread& spread) {
  if (spread.count == 0) return {};
  return std::string(name) + ": p50 " + Print(spread.p50) + ", p95 " + Print(spread.p95) +
         ", p99 " + Print(spread.p99) + ", max " + Print(spread.max) + "\n";
}

std::string ToJson(const Spread& spread) {
  JsonObject object;
  object.Add("count", spread.count);
  if (spread.count > 0) {
    object.Add("p50", JsonSeconds(spread.p50)).Add("p95", JsonSeconds(spread.p95));
    object.Add("p99", JsonSeconds(spread.p99)).Add("max", JsonSeconds(spread.max));
  }
  return object.Finish();
}

std::string ToJson(const NodeStatistics& node) {
  char flips[32];
  std::snprintf(flips, sizeof flips, "%.3f", node.flips_per_minute);
  return JsonObject()
      .AddText("node", node.path)
      .AddText("id", node.id)
      .Add("ticks", node.ticks)
      .Add("successes", node.results_of(Status::kSuccess))
      .Add("failures", node.results_of(Status::kFailure))
      .Add("running", node.results_of(Status::kRunning))
      .Add("skipped", node.results_of(Status::kSkipped))
      .Add("halted", node.results_of(Status::kIdle))
      .Add("activations", ToJson(node.activations))
      .Add("flips", node.flips)
      .Add("flips_per_minute", std::string(flips))
      .Add("first_tick", node.first_tick)
      .Add("last_tick", node.last_tick)
      .Finish();
}

}  // namespace

std::string PrintStatistics(const Statistics& statistics, StatisticsOrder order) {
  std::string text = std::to_string(statistics.ticks) + " ticks in " + Print(statistics.time);
  if (statistics.paused > Duration(0)) {
    text += ", of which it stood still for " + Print(statistics.paused);
  }
  if (statistics.lost_ticks > 0) {
    text += ", " + std::to_string(statistics.lost_ticks) + " more are missing";
  }
  text += "\n" + Print("duration of a tick", statistics.tick_durations) +
          Print("from tick to tick", statistics.periods) + "\n";
  text += Line({"ticks", "success", "failure", "running", "skipped", "halted", "runs", "p50", "p95",
                "max", "flips/min", "first", "last", "node"});
  for (const NodeStatistics* node : Sorted(statistics, order)) text += Line(CellsOf(*node));
  return text;
}

std::string StatisticsToJson(const Statistics& statistics, StatisticsOrder order) {
  return JsonObject()
      .Add("ticks", statistics.ticks)
      .Add("seconds", JsonSeconds(statistics.time))
      .Add("paused_seconds", JsonSeconds(statistics.paused))
      .Add("lost_ticks", statistics.lost_ticks)
      .Add("tick_durations", ToJson(statistics.tick_durations))
      .Add("periods", ToJson(statistics.periods))
      .Add("nodes", JsonArray(Sorted(statistics, order),
                              [](const NodeStatistics* node) { return ToJson(*node); }))
      .Finish();
}

}  // namespace coppice
