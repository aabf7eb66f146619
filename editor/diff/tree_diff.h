// Two versions of a tree, compared node by node.
//
//   ~ 1.2 Retry: num_attempts "3" -> "5"
//   + 1.3 OpenDoor
//   - 1.3 PickLock
//   > 1.4 SmashDoor (was 1.2)
#ifndef COPPICE_EDITOR_DIFF_TREE_DIFF_H_
#define COPPICE_EDITOR_DIFF_TREE_DIFF_H_

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "editor/scene/scene.h"

namespace coppice::editor {

enum class DiffKind : std::uint8_t { kAdded, kRemoved, kMoved, kChanged };

/// "added", "removed", "moved", "changed".
const char* ToString(DiffKind kind);

struct AttributeChange {
  std::string name;
  std::string before;  ///< empty: there was none
  std::string after;
};

struct NodeDiff {
  DiffKind kind = DiffKind::kChanged;
  std::uint32_t before = kNoSceneNode;      ///< kNoSceneNode: added
  std::uint32_t after = kNoSceneNode;       ///< kNoSceneNode: removed
  std::vector<AttributeChange> attributes;  ///< of a changed node: type, name, ports
};

/// A node that was moved and changed is there twice. What only stands elsewhere because others came
/// or went is not there. In the order of the tree after, then what was removed.
std::vector<NodeDiff> DiffTrees(const Scene& before, const Scene& after);

/// One line as above.
std::string ToString(const NodeDiff& diff, const Scene& before, const Scene& after);

/// Both versions as one tree: that after, with the removed nodes where they were. What changed says
/// both: a port "3 → 5", a name "Fallback (was Sequence)". Views point into what both scenes point
/// into, and into `texts`.
struct MergedTree {
  Scene scene;
  std::deque<std::string> texts;
  std::vector<std::uint8_t> kinds;  ///< by node: 0 the same, else 1 + DiffKind
  std::vector<std::uint32_t>
      of_before;                        ///< by node of the scene before; kNoSceneNode: see of_after
  std::vector<std::uint32_t> of_after;  ///< by node of the scene after

  /// The node that a difference of the two scenes is about.
  std::uint32_t NodeOf(const NodeDiff& diff) const {
    return diff.after == kNoSceneNode ? of_before[diff.before] : of_after[diff.after];
  }
};
MergedTree MergeTrees(const Scene& before, const Scene& after);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DIFF_TREE_DIFF_H_
