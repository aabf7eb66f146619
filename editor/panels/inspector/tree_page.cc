#include <utility>

#include "editor/panels/inspector/pages.h"
#include "editor/panels/widgets/inspector_row.h"
#include "editor/workspace/type_editor.h"

namespace coppice::editor {
namespace {

// "input Pose2D = 0;0;0", and whether only its nodes say so.
std::string Words(const InterfacePort& port) {
  std::string words = ToString(port.model.direction);
  if (!port.model.type.empty()) words += " " + port.model.type;
  if (port.model.default_text) words += " = " + *port.model.default_text;
  return port.declared ? words : words + " (not declared)";
}

void DrawInterface(const Ui& ui, EditorState& state, const std::string& tree,
                   const ProjectFiles& files) {
  const auto& ports = state.inspector.interfaces.Of(tree, state.workspace, files);
  HeadingRow(ui, "interface");
  for (const InterfacePort& port : ports) {
    const Color color = port.declared ? ui.palette.text : ui.palette.text_dim;
    const std::string words = Words(port);
    const Row row = ValueRow(ui, "inspector/interface/" + port.model.name, port.model.name, words,
                             {Face::kSans, 12, color});
    if (row.hovered) {
      Tooltip(ui, port.model.description.empty() ? words : words + "\n" + port.model.description);
    }
  }
  if (TreeEditor(state, ui.now).CanEdit()) DrawTypeAction(ui, state, tree);
}

}  // namespace

void DrawTreePage(const Ui& ui, EditorState& state) {
  const std::string tree = state.workspace.ShownTreeId();
  if (tree.empty()) return;
  const ProjectFiles files = ProjectEditor(state, ui.now).Files();
  ImGui::SetCursorPosY(4 * ui.scale);
  FieldLook look;
  look.color = ui.palette.text;
  const FieldResult id =
      FieldRow(ui, state, "inspector/tree", "tree@" + tree, "tree", tree, look, "");
  const std::size_t uses = state.inspector.interfaces.UsesOf(tree, state.workspace, files);
  const std::string used = uses == 0 ? "in no other tree" : "in " + Count(uses, "place");
  if (ValueRow(ui, "inspector/used", "used", used, {Face::kSans, 12, ui.palette.text}).clicked &&
      uses > 0) {
    state.after_frame = [&state] { state.commands.Run("tree.usages"); };
  }
  DrawInterface(ui, state, tree, files);
  if (!id.value) return;
  state.after_frame = [&state, now = ui.now, to = *id.value] {
    const Outcome renamed = ProjectEditor(state, now).RenameTree(to);
    if (!renamed) state.Notify(renamed.problem(), now, true);
  };
}

}  // namespace coppice::editor
