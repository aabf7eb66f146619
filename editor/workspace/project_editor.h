// What the user does to whole trees and to names that several files share; the counterpart of
// TreeEditor, which changes nodes.
//
//   ProjectEditor edit(state, ui.now);
//   const Outcome done = edit.Extract("Dock");
#ifndef COPPICE_EDITOR_WORKSPACE_PROJECT_EDITOR_H_
#define COPPICE_EDITOR_WORKSPACE_PROJECT_EDITOR_H_

#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "editor/document/project_names.h"
#include "editor/document/search.h"
#include "editor/workspace/tree_editor.h"

namespace coppice::editor {

class ProjectEditor {
 public:
  ProjectEditor(EditorState& state, double now) : state_(state), now_(now), edit_(state, now) {}

  /// The shown project as it is now; files whose text is malformed are not in it.
  ProjectFiles Files() const;

  /// One step of that name: the edits of the files, one for each.
  Outcome Change(const std::string& name, const ProjectFiles& files,
                 const std::vector<Edit>& edits);

  /// Makes a tree of the selected node.
  Outcome Extract(const std::string& id);
  /// Puts its tree in the place of the selected SubTree.
  Outcome Inline();

  /// Makes an empty tree in the file of the shown one, and shows it.
  Outcome NewTree(const std::string& id);
  /// Deletes the shown tree; refuses if a SubTree stands for it.
  Outcome DeleteTree();
  /// Renames the shown tree wherever it is used.
  Outcome RenameTree(const std::string& id);
  /// Makes a file of format 3 one of format 4, as `coppice upgrade` does.
  Outcome MakeFormat4(const std::string& path);
  /// Includes a file into the shown one; writes an empty one if there is none.
  Outcome Include(const std::string& path);

  /// The keys that the selected nodes name, each once.
  std::vector<std::string> SelectedKeys() const;
  /// Renames a key of the tree that the selected node is in.
  Outcome RenameKey(const std::string& key, const std::string& to);

  Outcome ReplaceAll(const std::vector<Match>& matches, const Query& query,
                     const std::string& with);

  /// Shows and selects an element.
  void GoTo(const std::string& path, std::uint32_t offset);
  /// Shows the tree of that ID; false if there is none.
  bool ShowTree(const std::string& id);
  /// Shows the tree that the selected SubTree stands for; opens the file beside the shown one that
  /// has it if the shown ones do not.
  Outcome GoToDefinition();

  /// ID of the tree in which the selected node is defined: that of the SubTree which it was opened
  /// in, else the shown tree. Empty if nothing is selected.
  std::string TreeAroundSelection() const;

 private:
  const NodeModels& Models() const { return *state_.workspace.file()->models; }
  Outcome CheckId(const std::string& id) const;
  bool OpenTreeBeside(const std::string& path, const std::string& id);

  EditorState& state_;
  const double now_;
  TreeEditor edit_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_PROJECT_EDITOR_H_
