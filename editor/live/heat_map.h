// A number for each node of a scene, painted as heat: where the time goes, what fails, what was
// never ticked. The canvas only shows it; whoever has the statistics fills it.
#ifndef COPPICE_EDITOR_LIVE_HEAT_MAP_H_
#define COPPICE_EDITOR_LIVE_HEAT_MAP_H_

#include <cstdint>
#include <vector>

namespace coppice::editor {

enum class HeatMode : std::uint8_t { kTime, kTicks, kFailures, kNeverTicked };

/// "time", "ticks", "failures", "never ticked".
inline const char* ToString(HeatMode mode) {
  return mode == HeatMode::kTime       ? "time"
         : mode == HeatMode::kTicks    ? "ticks"
         : mode == HeatMode::kFailures ? "failures"
                                       : "never ticked";
}

struct HeatMap {
  HeatMode mode = HeatMode::kTime;
  std::vector<float> values;  ///< by node of the scene: 0 to 1; negative: never ticked
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_HEAT_MAP_H_
