#include "editor/workspace/comparison.h"

#include <utility>

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
  const std::shared_ptr<const Scene> scene(merged, &merged->tree.scene);
  view_.SetScene(scene, size_of, now);
  if (another) view_.needs_fit = true;
}

}  // namespace coppice::editor
