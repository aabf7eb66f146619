#include "editor/live/run_figures.h"

#include <algorithm>

namespace coppice::editor {

Recording PartOf(const Recording& run, std::size_t first, std::size_t end) {
  Recording part;
  if (run.sections().empty()) return part;
  const TickView view = run.Before(first);
  HistoryState state;
  state.tick = view.events.tick;
  state.time = view.events.start;
  state.statuses = view.statuses;
  state.values = view.values;
  std::size_t tree = run.TreeOf(first);
  part.OnTree(run.trees()[tree]);
  part.OnState(state);
  auto section = std::upper_bound(
      run.sections().begin(), run.sections().end(), first,
      [](std::size_t tick, const Recording::Section& s) { return tick < s.first_tick; });
  for (std::size_t tick = first; tick < end; ++tick) {
    for (; section != run.sections().end() && section->first_tick <= tick; ++section) {
      if (section->tree != tree) part.OnTree(run.trees()[tree = section->tree]);
      part.OnState(section->state);
    }
    part.OnTick(run.EventsOf(tick));
  }
  for (const Recording::Note& note : run.notes()) part.OnNote(note.note);  // pauses
  return part;
}

void RunFigures::Update(const Run& run, const Range& range) {
  const bool is_old = run.size() > size_ + size_ / 10 + 20 || (size_ != run.size() && size_ < 50);
  if (run_ == &run && range_ == range && (!is_old || range)) return;
  run_ = &run;
  range_ = range;
  size_ = run.size();
  if (range) {
    const std::size_t first = run.TickAt(range->first);
    statistics_ = StatisticsOf(PartOf(run.recording(), first, run.TickAt(range->second) + 1));
  } else {
    statistics_ = StatisticsOf(run.recording());
  }
  by_path_.clear();
  for (std::size_t i = 0; i < statistics_.nodes.size(); ++i) {
    by_path_.emplace(statistics_.nodes[i].path, i);
  }
}

const NodeStatistics* RunFigures::Find(const std::string& path) const {
  const auto at = by_path_.find(path);
  return at == by_path_.end() ? nullptr : &statistics_.nodes[at->second];
}

HeatMap RunFigures::Heat(HeatMode mode, const TreeDescription& tree, const Scene& scene) const {
  HeatMap map;
  map.mode = mode;
  map.values.assign(scene.nodes.size(), -1);
  float most = 0;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const NodeIndex in_run = scene.nodes[i].run_node;
    if (in_run >= tree.nodes.size()) continue;
    const NodeStatistics* node = Find(tree.nodes[in_run].path);
    if (!node || node->ticks == 0) continue;
    float value = 0;
    if (mode == HeatMode::kTime) {
      value = static_cast<float>(node->activations.p50.count()) *
              static_cast<float>(node->activations.count);
    } else if (mode == HeatMode::kTicks) {
      value = static_cast<float>(node->ticks);
    } else if (mode == HeatMode::kFailures) {
      value =
          static_cast<float>(node->results_of(Status::kFailure)) / static_cast<float>(node->ticks);
    }
    map.values[i] = value;
    most = std::max(most, value);
  }
  const bool is_share = mode == HeatMode::kFailures || mode == HeatMode::kNeverTicked;
  if (is_share || most <= 0) return map;
  for (float& value : map.values) {
    if (value > 0) value /= most;
  }
  return map;
}

}  // namespace coppice::editor
