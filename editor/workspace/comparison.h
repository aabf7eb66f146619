// The shown tree against another version of its file: both merged into one tree, with the changes
// by node. The other version is read once; the merged tree follows what is being edited.
#ifndef COPPICE_EDITOR_WORKSPACE_COMPARISON_H_
#define COPPICE_EDITOR_WORKSPACE_COMPARISON_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "editor/canvas/paint/node_look.h"
#include "editor/canvas/tree_view.h"
#include "editor/diff/tree_diff.h"
#include "editor/scene/forest.h"
#include "editor/scene/node_models.h"

namespace coppice::editor {

class Comparison {
 public:
  /// Reads the other version, the one before. A problem if there is no tree in it.
  static Expected<std::unique_ptr<Comparison>> With(const std::string& path);

  /// What a scene points into.
  using Alive = std::vector<std::shared_ptr<const void>>;

  /// Compares with this tree, which is what it was compared with the last time or another. `alive`
  /// is kept as long as the scene.
  void Follow(const std::shared_ptr<const Scene>& after, Alive alive, const LayoutStyle& style,
              const TreeView::SizeOf& size_of, double now);

  const std::string& path() const { return path_; }
  /// "2 added, 1 changed", or "no difference".
  const std::string& summary() const { return summary_; }
  TreeView& view() { return view_; }
  const std::vector<Change>& changes() const { return changes_; }

  struct Difference {
    std::uint32_t node;    ///< of the merged tree
    std::string sentence;  ///< what differs
  };
  /// From the top of the merged tree to its bottom.
  const std::vector<Difference>& differences() const { return differences_; }
  /// The one that is selected; differences().size(): none.
  std::size_t selected() const { return selected_; }
  /// Selects it and its node, which comes into sight on a canvas of that size.
  void Select(std::size_t difference, Point canvas);

 private:
  void ListDifferences(const MergedTree& merged, const std::vector<NodeDiff>& diffs,
                       const Scene& before);

  std::string path_;
  Forest forest_;
  NodeModels models_;
  std::shared_ptr<const Scene> after_;
  std::string summary_;
  std::vector<Change> changes_;
  std::vector<Difference> differences_;
  std::size_t selected_ = 0;
  TreeView view_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_COMPARISON_H_
