// Two versions of trees as one picture: the version after, with the removed nodes where they were.
#ifndef COPPICE_EDITOR_EXPORT_DIFF_PICTURE_H_
#define COPPICE_EDITOR_EXPORT_DIFF_PICTURE_H_

#include <memory>
#include <vector>

#include "editor/canvas/paint/node_look.h"
#include "editor/diff/forest_diff.h"
#include "editor/export/tree_picture.h"

namespace coppice::editor {

/// The changes of a merged tree, by node.
std::vector<Change> ChangesOf(const MergedTree& merged);

/// The trees that differ, to be painted. Made of comparisons that must live as long as it.
class DiffPicture {
 public:
  explicit DiffPicture(const std::vector<TreeComparison>& trees);

  /// Adds them to a painting, which points into this.
  void AddTo(TreePainting& painting) const;

 private:
  struct Merged {
    std::string title;
    MergedTree tree;
    std::vector<Change> changes;
  };
  std::vector<std::unique_ptr<const Merged>> trees_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_EXPORT_DIFF_PICTURE_H_
