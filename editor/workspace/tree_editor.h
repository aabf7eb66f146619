// What the user does to the tree that is shown, as steps of the history: takes the selection, makes
// a named change of it, shows the result and selects what comes next. Keys, menus, panels and the
// canvas all change trees through this.
//
//   TreeEditor edit(state, ui.now);
//   edit.Delete();
//
// What cannot be done is said in state.notice, and nothing changes. Cheap to make; keeps nothing.
#ifndef COPPICE_EDITOR_WORKSPACE_TREE_EDITOR_H_
#define COPPICE_EDITOR_WORKSPACE_TREE_EDITOR_H_

#include <functional>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "editor/document/draft.h"
#include "editor/document/node_rules.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Where a new node goes, seen from the selected one.
enum class AddWhere { kChild, kAfter, kAround };

class TreeEditor {
 public:
  TreeEditor(EditorState& state, double now) : state_(state), now_(now) {}

  /// Whether the shown tree can be changed.
  Outcome CanEdit() const;

  /// Makes `xml`, one element, a child of the selected node, its next sibling, or its parent. A
  /// leaf gets a sibling instead of a child; an empty tree its root. `type` is for the name of the
  /// step. False if it was refused.
  bool Add(const std::string& xml, const std::string& type, AddWhere where);
  /// Where Add(kChild) would put it: "into Sequence", "behind Beep", "as the root of Main".
  std::string PlaceOfNew() const;

  /// The selected elements, by file and offset.
  std::vector<FilePlace> SelectedPlaces() const;

  /// The name that the selected node has in the XML.
  std::string GivenName() const;

  void Delete();
  void DeleteKeepingChildren();
  void MoveAmongSiblings(int by);
  void Promote();
  void Demote();
  void ToggleDisabled();
  /// The ports that changing to this type would take away: "a, b".
  std::string LostByChange(const std::string& type) const;
  bool ChangeType(const std::string& type);
  bool Rename(const std::string& name);
  bool SetValue(const std::string& attribute, const std::string& value);
  bool ClearValue(const std::string& attribute);
  /// Gives the node an empty attribute of that name.
  bool AddPort(const std::string& name);

  /// All nodes of the shown tree, not those of the trees that it uses.
  void SelectAll();
  /// A copy of the selection behind it; the copy is selected.
  void Duplicate();
  void Copy();
  void Cut();
  /// `text` from the clipboard; with errors in it nothing is pasted, and the errors are shown.
  void Paste(const std::string& text, AddWhere where);

  /// Moves the selection into that node, before child number `position`; for drag and drop.
  bool MoveInto(const ElementPlace& parent, std::uint32_t position);

  void Undo();
  void Redo();
  /// Of every file that somebody else has changed.
  void TakeTheirs();
  /// The same, where the user's changes stay.
  void MergeTheirs();

  using Edit = std::function<Outcome(Draft&, const NodeRules&)>;
  /// Runs an edit on the selected elements of each file; one step of that name.
  bool Run(const std::string& name, const Edit& edit);
  /// The same; what cannot be done is told to the caller alone.
  Outcome Try(const std::string& name, const Edit& edit);
  /// The same on elements of one file. Selects what the edit selects.
  bool RunOn(const std::string& name, const std::string& path,
             const std::vector<ElementIndex>& elements, const Edit& edit);

 private:
  struct Selected {
    std::string path;
    std::vector<ElementIndex> elements;
  };
  std::vector<Selected> Selection() const;
  std::string SelectedText() const;
  const Document& DocumentOf(const std::string& path) const;
  NodeRules Rules() const;
  std::string What() const;
  std::vector<std::string> Disputed() const;  // paths of files that somebody else changed too
  Outcome RunAll(const std::string& name, const std::vector<Selected>& selection, const Edit& edit);
  bool InsertAll(const std::string& name, const std::vector<std::string>& fragments,
                 AddWhere where);
  void Show(const std::vector<FilePlace>& places);
  bool Refuse(std::string why);
  bool Report(const Outcome& outcome);  // true if it was done

  EditorState& state_;
  const double now_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_TREE_EDITOR_H_
