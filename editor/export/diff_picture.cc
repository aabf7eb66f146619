#include "editor/export/diff_picture.h"

#include <utility>

namespace coppice::editor {

std::vector<Change> ChangesOf(const MergedTree& merged) {
  std::vector<Change> changes;
  changes.reserve(merged.kinds.size());
  for (const std::uint8_t kind : merged.kinds) changes.push_back(static_cast<Change>(kind));
  return changes;
}

DiffPicture::DiffPicture(const std::vector<TreeComparison>& trees) {
  for (const TreeComparison& tree : trees) {
    if (tree.diffs.empty()) continue;
    auto merged = std::make_unique<Merged>();
    merged->title = tree.id + ": " + CountDiffs(tree.diffs);
    merged->tree = MergeTrees(tree.before, tree.after);
    merged->changes = ChangesOf(merged->tree);
    trees_.push_back(std::move(merged));
  }
}

void DiffPicture::AddTo(TreePainting& painting) const {
  for (const auto& merged : trees_) {
    painting.trees.push_back({&merged->tree.scene, merged->title, &merged->changes});
  }
}

}  // namespace coppice::editor
