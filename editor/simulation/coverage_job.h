// Runs a tree many times by chance (bt_core/testing/random_runs.h), some runs in every frame, so
// the editor goes on meanwhile; then says what was reached, for lists and for the canvas.
//
//   CoverageJob job;
//   job.Start(program, options, 1000);
//   while (job.is_running()) job.Update();        // once per frame
//   job.Find("patrol/dock")->ticks();
#ifndef COPPICE_EDITOR_SIMULATION_COVERAGE_JOB_H_
#define COPPICE_EDITOR_SIMULATION_COVERAGE_JOB_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

#include "bt_core/frames/tree_description.h"
#include "bt_core/testing/random_runs.h"
#include "editor/live/heat_map.h"
#include "editor/scene/scene.h"

namespace coppice::editor {

class CoverageJob {
 public:
  /// Takes the place of what there was.
  void Start(std::shared_ptr<const Program> program, RandomRunOptions options, std::uint64_t runs);
  void Clear() { *this = {}; }

  /// Does as many runs as take some milliseconds, at least one.
  void Update();
  bool is_running() const { return random_ && coverage()->runs < wanted_; }
  std::uint64_t wanted() const { return wanted_; }

  /// So far; null if nothing was started.
  const Coverage* coverage() const { return random_ ? &random_->coverage() : nullptr; }
  /// The tree that was run; there must be one.
  const Program& program() const { return random_->program(); }
  /// How; something must have been started.
  const RandomPlay& play() const { return random_->play(); }
  /// Of a node; null if it is not known.
  const NodeCoverage* Find(const std::string& path) const;

  /// For the canvas: the share of ticks that failed, or how often a node was ticked, by the
  /// logarithm.
  HeatMap Heat(HeatMode mode, const TreeDescription& tree, const Scene& scene) const;

 private:
  std::optional<RandomRuns> random_;
  std::uint64_t wanted_ = 0;
  std::unordered_map<std::string, std::size_t> by_path_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SIMULATION_COVERAGE_JOB_H_
