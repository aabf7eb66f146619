// What the user does to types of nodes: their models in <TreeNodesModel>. The counterpart of
// TreeEditor, which changes nodes, and ProjectEditor, which changes trees; of a tree the model is
// its interface. Everything is one named step that can be undone.
//
//   TypeEditor edit(state, ui.now);
//   const Outcome done = edit.Define("GoTo");
#ifndef COPPICE_EDITOR_WORKSPACE_TYPE_EDITOR_H_
#define COPPICE_EDITOR_WORKSPACE_TYPE_EDITOR_H_

#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "editor/document/tree_interface.h"
#include "editor/workspace/project_editor.h"

namespace coppice::editor {

class TypeEditor {
 public:
  TypeEditor(EditorState& state, double now)
      : state_(state), project_(state, now), files_(project_.Files()) {}

  /// True if a file of the project has the model, so that it can be changed here.
  bool IsDefined(const std::string& type) const { return !FileOf(type).empty(); }
  /// Path of the file that has the model, or empty.
  std::string FileOf(const std::string& type) const;

  /// Writes a model as the nodes of this type suggest it, with what their attributes are as ports;
  /// of a tree, with the keys that it shares. Into the file that has models, else the shown one.
  Outcome Define(const std::string& type);
  Outcome Remove(const std::string& type);
  /// Into another file of the project.
  Outcome MoveTo(const std::string& type, const std::string& path);

  Outcome SetKind(const std::string& type, NodeCategory kind);
  Outcome Describe(const std::string& type, const std::string& description);
  Outcome AddPort(const std::string& type, const PortModel& port);
  Outcome RemovePort(const std::string& type, const std::string& port);
  /// A new name changes the nodes as well; of a tree, the key inside too.
  Outcome ChangePort(const std::string& type, const std::string& port, const PortModel& to);

  /// A name that no port of the type has: "port", "port_2".
  std::string FreePortName(const std::string& type) const;

 private:
  struct Model {
    std::size_t file = 0;
    ElementIndex element = kNoElement;
  };
  Model Find(const std::string& type) const;
  const NodeModels& Models() const { return *state_.workspace.file()->models; }
  NodeModel Suggested(const std::string& type) const;
  std::size_t FileForNew() const;
  Expected<std::vector<Edit>> RenamedPort(const std::string& type, const std::string& port,
                                          const std::string& to) const;
  /// Changes one file.
  Outcome Change(const std::string& name, std::size_t file, Edit edit);

  EditorState& state_;
  ProjectEditor project_;
  ProjectFiles files_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_TYPE_EDITOR_H_
