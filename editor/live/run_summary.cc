#include "editor/live/run_summary.h"

#include <cinttypes>
#include <cstdio>

namespace coppice::editor {

std::string SummaryOf(const RunView& run) {
  char text[96];
  const auto& ticks = run.run().recording().ticks();
  const std::uint64_t number = ticks.empty() ? 0 : ticks.back().number;
  switch (run.phase()) {
    case RunPhase::kLive:
      std::snprintf(text, sizeof(text), "%.0f Hz   tick %" PRIu64, run.rate(), number);
      return text;
    case RunPhase::kLoading:
      std::snprintf(text, sizeof(text), "loading %.0f %%", run.source().progress() * 100);
      return text;
    case RunPhase::kSimulation:  // it goes on from where it is shown
      return "tick " +
             std::to_string(run.is_at_beginning() ? 0 : ticks[run.playhead().tick()].number);
    case RunPhase::kRecord:
      return "record   tick " + std::to_string(number);
    default: {
      const std::string& problem = run.connection().problem;
      return ToString(run.phase()) + (problem.empty() ? "" : ": " + problem);
    }
  }
}

}  // namespace coppice::editor
