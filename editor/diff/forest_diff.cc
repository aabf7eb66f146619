#include "editor/diff/forest_diff.h"

#include <array>
#include <utility>

namespace coppice::editor {
namespace {

constexpr std::size_t kClosed = 0;  // limit of a scene whose SubTrees are not written out

TreeComparison Compare(const std::string& id, const ForestVersion& before,
                       const ForestVersion& after) {
  TreeComparison tree;
  tree.id = id;
  tree.before = BuildScene(before.forest, before.forest.Find(id), before.models, kClosed);
  tree.after = BuildScene(after.forest, after.forest.Find(id), after.models, kClosed);
  tree.diffs = DiffTrees(tree.before, tree.after);
  return tree;
}

}  // namespace

std::vector<TreeComparison> CompareForests(const ForestVersion& before,
                                           const ForestVersion& after) {
  std::vector<TreeComparison> trees;
  for (const TreeEntry& entry : after.forest.trees()) {
    trees.push_back(Compare(entry.id, before, after));
  }
  for (const TreeEntry& entry : before.forest.trees()) {
    if (after.forest.Find(entry.id) < 0) trees.push_back(Compare(entry.id, before, after));
  }
  return trees;
}

std::string CountDiffs(const std::vector<NodeDiff>& diffs) {
  std::array<std::size_t, 4> counts{};
  for (const NodeDiff& diff : diffs) ++counts[static_cast<std::size_t>(diff.kind)];
  std::string text;
  for (const DiffKind kind :
       {DiffKind::kAdded, DiffKind::kRemoved, DiffKind::kMoved, DiffKind::kChanged}) {
    const std::size_t count = counts[static_cast<std::size_t>(kind)];
    if (count == 0) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + ToString(kind);
  }
  return text;
}

std::string PlaceOf(const NodeDiff& diff, const TreeComparison& tree, const Forest& before,
                    const Forest& after) {
  const bool removed = diff.after == kNoSceneNode;
  const SceneNode& node = removed ? tree.before.nodes[diff.before] : tree.after.nodes[diff.after];
  const Document& document = *(removed ? before : after).documents()[node.document];
  const SourceLocation where = document.Location(document.element(node.element).offset);
  return where.file + ":" + std::to_string(where.line);
}

}  // namespace coppice::editor
