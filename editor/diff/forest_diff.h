// Two versions of a file, compared tree by tree. SubTrees are compared where they are defined, not
// where they are used.
#ifndef COPPICE_EDITOR_DIFF_FOREST_DIFF_H_
#define COPPICE_EDITOR_DIFF_FOREST_DIFF_H_

#include <string>
#include <vector>

#include "editor/diff/tree_diff.h"
#include "editor/scene/forest.h"

namespace coppice::editor {

/// One version: the trees, and what is known of their nodes. Both must live as long as what is made
/// of them.
struct ForestVersion {
  const Forest& forest;
  const NodeModels& models;
};

/// A tree of the same ID in both versions. Of one that only one version has, the other scene is
/// empty, and every node was added or removed.
struct TreeComparison {
  std::string id;
  Scene before, after;
  std::vector<NodeDiff> diffs;  ///< empty: the trees are the same
};

/// Every tree: those of the version after in their order, then those that are gone.
std::vector<TreeComparison> CompareForests(const ForestVersion& before, const ForestVersion& after);

/// "2 added, 1 changed"; a node that was moved and changed counts for both. Empty if nothing.
std::string CountDiffs(const std::vector<NodeDiff>& diffs);

/// "b.xml:12": where the node stands, in the version that has it.
std::string PlaceOf(const NodeDiff& diff, const TreeComparison& tree, const Forest& before,
                    const Forest& after);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DIFF_FOREST_DIFF_H_
