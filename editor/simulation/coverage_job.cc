#include "editor/simulation/coverage_job.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace coppice::editor {
namespace {

constexpr auto kPerFrame = std::chrono::milliseconds(5);

float HeatOf(const NodeCoverage& node, HeatMode mode, std::uint64_t most) {
  const auto ticks = static_cast<float>(node.ticks());
  if (mode == HeatMode::kNeverTicked) return 0;
  if (mode == HeatMode::kFailures) {
    return static_cast<float>(node.results_of(Status::kFailure)) / ticks;
  }
  return std::log1p(ticks) / std::log1p(static_cast<float>(most));
}

}  // namespace

void CoverageJob::Start(std::shared_ptr<const Program> program, RandomRunOptions options,
                        std::uint64_t runs) {
  random_.emplace(std::move(program), std::move(options));
  wanted_ = runs;
  by_path_.clear();
  const std::vector<NodeCoverage>& nodes = coverage()->nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) by_path_.emplace(nodes[i].path, i);
}

void CoverageJob::Update() {
  const auto end = std::chrono::steady_clock::now() + kPerFrame;
  while (is_running()) {
    random_->Run();
    if (std::chrono::steady_clock::now() >= end) return;
  }
}

const NodeCoverage* CoverageJob::Find(const std::string& path) const {
  const auto at = by_path_.find(path);
  return at == by_path_.end() ? nullptr : &coverage()->nodes[at->second];
}

HeatMap CoverageJob::Heat(HeatMode mode, const TreeDescription& tree, const Scene& scene) const {
  HeatMap map;
  map.mode = mode;
  map.values.assign(scene.nodes.size(), -1);
  if (!random_) return map;
  std::uint64_t most = 1;
  for (const NodeCoverage& node : coverage()->nodes) most = std::max(most, node.ticks());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const NodeIndex in_run = scene.nodes[i].run_node;
    if (in_run >= tree.nodes.size()) continue;
    const NodeCoverage* node = Find(tree.nodes[in_run].path);
    if (node && node->ticks() > 0) map.values[i] = HeatOf(*node, mode, most);
  }
  return map;
}

}  // namespace coppice::editor
