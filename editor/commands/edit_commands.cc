#include "editor/commands/edit_commands.h"

#include <utility>

#include "editor/workspace/node_ports.h"
#include "editor/workspace/type_editor.h"

namespace coppice::editor {
namespace {

enum class Way { kBack, kForth, kOut, kIn };

class EditCommands {
 public:
  explicit EditCommands(EditorState& state) : state_(state) {}

  void AddAll() {
    AddNodes();
    AddMoves();
    AddClipboard();
    Add("edit.undo", "Undo", {'Z', kCtrl}, &TreeEditor::Undo);
    Add("edit.redo", "Redo", {'Z', kCtrl | kShift}, &TreeEditor::Redo);
    state_.commands.AddKeys("edit.redo", {'Y', kCtrl});
    Add("edit.select_all", "Select all nodes of the tree", {'A', kCtrl}, &TreeEditor::SelectAll);
    Add("edit.duplicate", "Duplicate", {'D', kCtrl}, &TreeEditor::Duplicate);
    AddTyping();
    AddTypes();
  }

 private:
  using Member = void (TreeEditor::*)();

  void AddFunction(std::string id, std::string title, KeyChord keys,
                   std::function<void(TreeEditor)> run) {
    state_.commands.Add({std::move(id), std::move(title), keys,
                         [&s = state_, run = std::move(run)] { run(TreeEditor(s, s.now)); }});
  }

  void Add(std::string id, std::string title, KeyChord keys, Member run) {
    AddFunction(std::move(id), std::move(title), keys, [run](TreeEditor edit) { (edit.*run)(); });
  }

  // A popup that only makes sense where something can be changed.
  void AddPopup(std::string id, std::string title, KeyChord keys, Popup popup,
                bool needs_selection) {
    AddFunction(std::move(id), std::move(title), keys,
                [&s = state_, popup, needs_selection](const TreeEditor& edit) {
                  const Outcome can = edit.CanEdit();
                  if (!can) return s.Notify(can.problem(), s.now, true);
                  const TreeView* view = s.workspace.view();
                  const bool selected = view && view->selected() != kNoSceneNode;
                  if (needs_selection && !selected) {
                    return s.Notify("nothing is selected", s.now, true);
                  }
                  s.OpenPopup(popup, popup == Popup::kRename ? edit.GivenName() : "");
                });
  }

  // Places to type in.
  void AddTyping() {
    AddFunction("edit.xml", "Edit the XML", {kKeyEnter, kCtrl}, [&s = state_](const TreeEditor&) {
      s.screen.tiles.xml = s.screen.tiles.row = true;
      s.xml.pane.wants_focus = true;
    });
    AddFunction("edit.first_port", "Edit the first port", {kKeyEnter},
                [&s = state_](const TreeEditor&) {
                  const TreeView* view = s.workspace.view();
                  if (!view || view->selected() == kNoSceneNode) return;
                  s.screen.tiles.inspector = true;
                  s.input.focus_field = FirstField(*view);
                });
    AddFunction("edit.ports_here", "Edit the ports on the node", {kKeyEnter, kShift},
                [&s = state_](const TreeEditor& edit) {
                  const TreeView* view = s.workspace.view();
                  if (!view || view->selected() == kNoSceneNode || !edit.CanEdit()) {
                    return;
                  }
                  const auto ports = PortNamesOf(s, *view->scene(), view->selected(), s.now);
                  if (!ports.empty()) EditPort(s, ports.front());
                });
  }

  void AddTypes() {
    AddFunction("type.define", "Define the type of the node, or the ports of the tree", {'I'},
                [&s = state_](const TreeEditor&) { DefineType(s); });
    AddFunction("edit.add_port", "Add a port to the node", {'I', kShift},
                [&s = state_](const TreeEditor&) {
                  s.screen.tiles.inspector = true;
                  s.inspector.type.clear();
                  s.input.focus_field = "inspector/new_port";
                });
  }

  // Opens the model in the inspector; makes it if there is none.
  static void DefineType(EditorState& state) {
    const TreeView* view = state.workspace.view();
    if (!state.workspace.file()) return state.Notify("no file is open", state.now, true);
    const bool is_node = view && view->selected() != kNoSceneNode;
    const std::string type = is_node ? std::string(view->scene()->nodes[view->selected()].id)
                                     : state.workspace.ShownTreeId();
    TypeEditor edit(state, state.now);
    if (!edit.IsDefined(type)) {
      const Outcome done = edit.Define(type);
      if (!done) return state.Notify(done.problem(), state.now, true);
    }
    view = state.workspace.view();
    state.screen.tiles.inspector = true;
    state.inspector.type = type;
    state.inspector.node = view ? view->selected() : kNoSceneNode;
  }

  static std::string FirstField(const TreeView& view) {
    const Scene& scene = *view.scene();
    const SceneNode& node = scene.nodes[view.selected()];
    const bool declared = node.model && node.shape != Shape::kSubTree && !node.model->ports.empty();
    if (declared) return "inspector/port/" + node.model->ports[0].name;
    if (node.port_count == 0) return "inspector/name";
    return "inspector/port/" + std::string(scene.ports[node.first_port].name);
  }

  void AddNodes() {
    AddPopup("edit.add", "Add node", {kKeyTab}, Popup::kAdd, false);
    AddPopup("edit.add_here", "Add node", {kKeySpace}, Popup::kAdd, false);
    AddPopup("edit.rename", "Rename", {kKeyF1 + 1}, Popup::kRename, true);
    AddPopup("edit.change_type", "Change type", {'R'}, Popup::kChangeType, true);
    Add("edit.delete", "Delete", {kKeyDelete}, &TreeEditor::Delete);
    Add("edit.delete_only", "Delete, but keep the children", {kKeyDelete, kCtrl},
        &TreeEditor::DeleteKeepingChildren);
    Add("edit.disable", "Disable or enable", {'D'}, &TreeEditor::ToggleDisabled);
  }

  void AddMoves() {
    AddMove("edit.move_up", "Move up", kKeyUp, Way::kOut, Way::kBack);
    AddMove("edit.move_down", "Move down", kKeyDown, Way::kIn, Way::kForth);
    AddMove("edit.move_left", "Move left", kKeyLeft, Way::kBack, Way::kOut);
    AddMove("edit.move_right", "Move right", kKeyRight, Way::kForth, Way::kIn);
  }

  // Nodes go where the arrows point to on the screen.
  void AddMove(std::string id, std::string title, Key key, Way top_to_bottom, Way left_to_right) {
    AddFunction(std::move(id), std::move(title), {key, kAlt}, [=, &s = state_](TreeEditor edit) {
      const TreeView* const view = s.workspace.view();
      const bool sideways = view && view->orientation() == Orientation::kLeftToRight;
      switch (sideways ? left_to_right : top_to_bottom) {
        case Way::kBack:
          return edit.MoveAmongSiblings(-1);
        case Way::kForth:
          return edit.MoveAmongSiblings(+1);
        case Way::kOut:
          return edit.Promote();
        case Way::kIn:
          return edit.Demote();
      }
    });
  }

  void AddClipboard() {
    Add("edit.copy", "Copy as XML", {'C', kCtrl}, &TreeEditor::Copy);
    Add("edit.cut", "Cut", {'X', kCtrl}, &TreeEditor::Cut);
    AddPaste("edit.paste", "Paste as child", {'V', kCtrl}, AddWhere::kChild);
    AddPaste("edit.paste_after", "Paste after", {'V', kCtrl | kShift}, AddWhere::kAfter);
  }

  void AddPaste(std::string id, std::string title, KeyChord keys, AddWhere where) {
    AddFunction(std::move(id), std::move(title), keys, [&s = state_, where](TreeEditor edit) {
      edit.Paste(s.services.get_clipboard(), where);
    });
  }

  EditorState& state_;
};

}  // namespace

void AddEditCommands(EditorState& state) { EditCommands(state).AddAll(); }

}  // namespace coppice::editor
