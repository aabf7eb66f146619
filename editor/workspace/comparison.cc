#include "editor/workspace/comparison.h"

#include <algorithm>
#include <utility>

#include "editor/diff/diff_sentence.h"
#include "editor/export/diff_picture.h"

namespace coppice::editor {
namespace {

// What a merged tree points into, kept alive by it.
struct Merged {
  std::shared_ptr<const Scene> before, after;
  Comparison::Alive alive;
  MergedTree tree;
};

}  // namespace

Expected<std::unique_ptr<Comparison>> Comparison::With(const std::string& path) {
  auto comparison = std::make_unique<Comparison>();
  Diagnostics diagnostics;
  comparison->path_ = path;
  comparison->forest_ = Forest::FromFile(path, diagnostics);
  if (comparison->forest_.trees().empty()) {
    return Problem{diagnostics.all().empty() ? "no tree in " + path
                                             : ToString(diagnostics.all().front())};
  }
  for (const Document* document : comparison->forest_.documents()) {
    comparison->models_.AddFrom(*document);
  }
  return comparison;
}

void Comparison::Follow(const std::shared_ptr<const Scene>& after, Alive alive,
                        const LayoutStyle& style, const TreeView::SizeOf& size_of, double now) {
  view_.SetStyle(style, now);
  if (after == after_) return;
  const bool another = !after_ || after_->tree_id != after->tree_id;
  after_ = after;
  auto merged = std::make_shared<Merged>();
  merged->after = after;
  merged->alive = std::move(alive);
  merged->before =
      std::make_shared<const Scene>(BuildScene(forest_, forest_.Find(after->tree_id), models_));
  const std::vector<NodeDiff> diffs = DiffTrees(*merged->before, *after);
  summary_ = diffs.empty() ? "no difference" : CountDiffs(diffs);
  merged->tree = MergeTrees(*merged->before, *after);
  changes_ = ChangesOf(merged->tree);
  ListDifferences(merged->tree, diffs, *merged->before);
  const std::shared_ptr<const Scene> scene(merged, &merged->tree.scene);
  view_.SetScene(scene, size_of, now);
  if (another) view_.needs_fit = true;
}

void Comparison::ListDifferences(const MergedTree& merged, const std::vector<NodeDiff>& diffs,
                                 const Scene& before) {
  differences_.clear();
  for (const NodeDiff& diff : diffs) {
    differences_.push_back({merged.NodeOf(diff), Sentence(diff, before, *after_)});
  }
  std::stable_sort(differences_.begin(), differences_.end(),
                   [](const Difference& a, const Difference& b) { return a.node < b.node; });
  selected_ = differences_.size();
}

void Comparison::Select(std::size_t difference, Point canvas) {
  selected_ = difference;
  view_.Select(differences_[difference].node);
  view_.Reveal(canvas);
}

}  // namespace coppice::editor
