// The tree of a run, made showable: its texts as a Forest, its node types as models, and compiled
// again for questions about it (bt_core/analysis).
#ifndef COPPICE_EDITOR_LIVE_RUN_TREE_H_
#define COPPICE_EDITOR_LIVE_RUN_TREE_H_

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/analysis/recorded_tree.h"
#include "bt_core/frames/tree_description.h"
#include "editor/scene/forest.h"
#include "editor/scene/node_models.h"
#include "editor/scene/scene.h"

namespace coppice::editor {

/// A leaf that asks people for help while it runs or fails.
struct AskingNode {
  NodeIndex node;
  std::string words;  ///< its question as the tree has it, or its path
};

/// Whether leaves of that type do so: AskSupervisor and RequestHelp (bt_nodes/operators), and types
/// whose model says so, <Metadata asks="people"/>.
bool AsksPeople(std::string_view id, const NodeModels& models);

class RunTree {
 public:
  /// `known`: models that the user has loaded; those of the run come on top.
  RunTree(std::shared_ptr<const TreeDescription> description, const NodeModels& known);

  const std::shared_ptr<const TreeDescription>& description() const { return description_; }
  const Forest& forest() const { return forest_; }
  const NodeModels& models() const { return models_; }
  const Diagnostics& problems() const { return problems_; }
  const std::vector<AskingNode>& asking() const { return asking_; }

  /// Compiled when it is asked for the first time.
  const RecordedTree& recorded() const;

 private:
  std::shared_ptr<const TreeDescription> description_;
  Diagnostics problems_;
  Forest forest_;
  NodeModels models_;
  std::vector<AskingNode> asking_;
  mutable std::optional<RecordedTree> recorded_;
};

/// Gives each node of the scene its number in the run: SceneNode::run_node. The scene was built
/// from the run's main tree; what the run does not know has none.
void NumberNodes(const TreeDescription& description, Scene& scene);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_RUN_TREE_H_
