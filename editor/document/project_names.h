// Names that several files share: IDs of trees, and keys that go through the ports of SubTrees.
// Changing one means changing it wherever it is used, in one step.
//
//   const std::vector<Edit> edits = RenameTree(files, "Walk", "Stroll");   // one per file
#ifndef COPPICE_EDITOR_DOCUMENT_PROJECT_NAMES_H_
#define COPPICE_EDITOR_DOCUMENT_PROJECT_NAMES_H_

#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/outcome.h"
#include "bt_core/model/document.h"
#include "bt_core/model/edit.h"
#include "editor/document/subtree_edits.h"
#include "editor/scene/node_models.h"

namespace coppice::editor {

/// The texts of a project as they are now.
using ProjectFiles = std::vector<Document>;

/// An element of one of the files.
struct ElementIn {
  std::size_t file = 0;
  ElementIndex element{0};
};

/// All <BehaviorTree>s.
std::vector<ElementIn> TreesIn(const ProjectFiles& files);
/// The <BehaviorTree>s of that ID; one, if the project is in order.
std::vector<ElementIn> TreesCalled(const ProjectFiles& files, std::string_view id);

/// The <SubTree>s that stand for the tree of that ID, in all trees.
std::vector<ElementIn> SubTreesOf(const ProjectFiles& files, std::string_view id);

CallersOfTree CallersOf(const ProjectFiles& files, std::string_view id);

/// Renames the definition, its SubTrees, the main tree and the model of the tree.
std::vector<Edit> RenameTree(const ProjectFiles& files, std::string_view id, std::string_view to);

/// Renames a key of the tree `in`: in ports and scripts, and as a port of the tree's SubTrees.
/// Trees that share all keys with it by _autoremap are renamed as well. Edits are one per file.
Expected<std::vector<Edit>> RenameKey(const ProjectFiles& files, const NodeModels& models,
                                      ElementIn in, const std::string& key, const std::string& to);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_PROJECT_NAMES_H_
