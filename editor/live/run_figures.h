// Statistics of a run that still grows, or of a stretch of it; worked out again when they are old.
#ifndef COPPICE_EDITOR_LIVE_RUN_FIGURES_H_
#define COPPICE_EDITOR_LIVE_RUN_FIGURES_H_

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "bt_core/analysis/statistics.h"
#include "editor/live/heat_map.h"
#include "editor/scene/scene.h"
#include "editor/timeline/run.h"

namespace coppice::editor {

/// The ticks from `first` up to and without `end`, as a run of its own, with all notes behind them.
Recording PartOf(const Recording& run, std::size_t first, std::size_t end);

class RunFigures {
 public:
  using Range = std::optional<std::pair<Time, Time>>;

  /// Works them out if the question is another one, or the run has grown by a tenth: so the work
  /// keeps in proportion to what comes. The run must have a tick.
  void Update(const Run& run, const Range& range);

  const Statistics& statistics() const { return statistics_; }
  /// Of a node; null if it is not known.
  const NodeStatistics* Find(const std::string& path) const;

  /// For the canvas; `tree` is that of the scene.
  HeatMap Heat(HeatMode mode, const TreeDescription& tree, const Scene& scene) const;

 private:
  const Run* run_ = nullptr;
  Range range_;
  std::size_t size_ = 0;
  Statistics statistics_;
  std::unordered_map<std::string, std::size_t> by_path_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_RUN_FIGURES_H_
