// Which nodes of two versions of a tree are the same node.
//
// What was not touched is found by its content, wherever it has gone; what was touched by where it
// stands. After J.-R. Falleri et al., "Fine-grained and accurate source code differencing", ASE
// 2014, doi 10.1145/2642937.2642982: first equal subtrees from the top, then what contains them.
#ifndef COPPICE_EDITOR_DIFF_TREE_MATCH_H_
#define COPPICE_EDITOR_DIFF_TREE_MATCH_H_

#include <cstdint>
#include <vector>

#include "editor/scene/scene.h"

namespace coppice::editor {

/// Both by node number; kNoSceneNode where the other tree has no such node.
struct TreeMatch {
  std::vector<std::uint32_t> before_of;  ///< for each node after, its node before
  std::vector<std::uint32_t> after_of;   ///< for each node before, its node after
};

/// What the nodes of a tree are compared by, by node number. Equal means the same, but for one case
/// in 2^64.
struct TreeHashes {
  std::vector<std::uint64_t> named;  ///< type and name
  std::vector<std::uint64_t> whole;  ///< type, name and ports, and everything below it
  std::vector<std::uint64_t> shown;  ///< all that is seen of the node alone
};

TreeHashes HashTree(const Scene& scene);

/// Time grows with the number of nodes.
TreeMatch MatchTrees(const Scene& before, const Scene& after);

/// The same for who has the hashes already.
TreeMatch MatchTrees(const Scene& before, const TreeHashes& before_hashes, const Scene& after,
                     const TreeHashes& after_hashes);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DIFF_TREE_MATCH_H_
