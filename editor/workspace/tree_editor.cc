#include "editor/workspace/tree_editor.h"

#include <algorithm>
#include <utility>

#include "bt_core/model/xml_text.h"
#include "editor/document/fragment.h"
#include "editor/document/tree_edits.h"

namespace coppice::editor {

bool TreeEditor::Refuse(std::string why) {
  state_.Notify(std::move(why), now_, true);
  return false;
}

bool TreeEditor::Report(const Outcome& outcome) {
  return outcome ? true : Refuse(outcome.problem());
}

Outcome TreeEditor::CanEdit() const {
  const Workspace& workspace = state_.workspace;
  if (workspace.run()) return Problem{"this is what the robot runs; open its file to change it"};
  if (!workspace.file()) return Problem{"no file is open"};
  if (workspace.IsOfOtherElements()) {
    return Problem{
        "format 4 has other nodes than this file of format 3: make it format 4 first, "
        "with the button in PROBLEMS"};
  }
  if (workspace.file()->is_stale || !workspace.ShownTree()) {
    return Problem{"the text of this file is malformed: correct it first"};
  }
  return {};
}

const Document& TreeEditor::DocumentOf(const std::string& path) const {
  return *state_.workspace.project().Find(path)->document;
}

NodeRules TreeEditor::Rules() const { return NodeRules(*state_.workspace.file()->models); }

std::vector<TreeEditor::Selected> TreeEditor::Selection() const {
  std::vector<Selected> selection;
  const TreeView* view = state_.workspace.view();
  if (!view) return selection;
  for (const std::uint32_t node : view->selection()) {
    const auto place = state_.workspace.PlaceOf(view->scene()->nodes[node]);
    if (!place) continue;
    auto at = std::find_if(selection.begin(), selection.end(),
                           [&](const Selected& one) { return one.path == place->path; });
    if (at == selection.end()) at = selection.insert(at, {place->path, {}});
    at->elements.push_back(place->element);
  }
  return selection;
}

std::vector<FilePlace> TreeEditor::SelectedPlaces() const {
  std::vector<FilePlace> places;
  for (const Selected& selected : Selection()) {
    for (const ElementIndex element : selected.elements) {
      places.push_back({selected.path, DocumentOf(selected.path).element(element).offset});
    }
  }
  return places;
}

// "Beep", or "3 nodes".
std::string TreeEditor::What() const {
  std::size_t count = 0;
  std::string name;
  for (const Selected& selected : Selection()) {
    const Document& document = DocumentOf(selected.path);
    const std::vector<ElementIndex> top = Topmost(document, selected.elements);
    if (count == 0) name = NameOf(document, top.front());
    count += top.size();
  }
  return count > 1 ? std::to_string(count) + " nodes" : name;
}

void TreeEditor::Show(const std::vector<FilePlace>& places) {
  state_.workspace.Refresh(now_);
  state_.workspace.SelectPlaces(places, now_);
  TreeView* view = state_.workspace.view();
  if (view) view->RevealIfLost(state_.screen.canvas_size);
}

Outcome TreeEditor::RunAll(const std::string& name, const std::vector<Selected>& selection,
                           const Edit& edit) {
  if (Outcome can = CanEdit(); !can) return can;
  if (selection.empty()) return Problem{"nothing is selected"};
  const NodeRules rules = Rules();
  NamedChange change;
  change.name = name;
  std::vector<FilePlace> after;
  for (const Selected& selected : selection) {
    Draft draft(DocumentOf(selected.path), selected.elements);
    if (Outcome edited = edit(draft, rules); !edited) return edited;
    change.files.push_back(std::move(draft).Finish(selected.path));
    for (const std::uint32_t offset : change.files.back().selected) {
      after.push_back({selected.path, offset});
    }
  }
  Diagnostics diagnostics;
  if (!state_.workspace.project().Do(std::move(change), SelectedPlaces(), diagnostics)) {
    return Problem{diagnostics.all().empty() ? "not possible" : diagnostics.all()[0].message};
  }
  Show(after);
  return {};
}

Outcome TreeEditor::Try(const std::string& name, const Edit& edit) {
  return RunAll(name, Selection(), edit);
}

bool TreeEditor::Run(const std::string& name, const Edit& edit) { return Report(Try(name, edit)); }

bool TreeEditor::RunOn(const std::string& name, const std::string& path,
                       const std::vector<ElementIndex>& elements, const Edit& edit) {
  return Report(RunAll(name, {{path, elements}}, edit));
}

std::string TreeEditor::PlaceOfNew() const {
  if (!CanEdit()) return {};
  const std::vector<Selected> selection = Selection();
  if (selection.empty()) return "as the root of \"" + state_.workspace.ShownTreeId() + "\"";
  const Document& document = DocumentOf(selection[0].path);
  const ElementIndex element = selection[0].elements.back();
  const std::string name(NameOf(document, element));
  return (Rules().MaxChildren(document, element) == 0 ? "after \"" : "into \"") + name + "\"";
}

bool TreeEditor::InsertAll(const std::string& name, const std::vector<std::string>& fragments,
                           AddWhere where) {
  if (!Report(CanEdit())) return false;
  const std::vector<Selected> selection = Selection();
  if (selection.empty()) {
    const ElementPlace tree = *state_.workspace.ShownTree();
    return RunOn(name, tree.path, {tree.element}, [&](Draft& draft, const NodeRules& rules) {
      return InsertNodes(draft, rules, tree.element, 0, fragments);
    });
  }
  const std::string path = selection.back().path;
  const ElementIndex element = selection.back().elements.back();
  const Document& document = DocumentOf(path);
  const bool behind = where == AddWhere::kAfter || Rules().MaxChildren(document, element) == 0;
  const ElementIndex parent = behind ? document.element(element).parent : element;
  const std::uint32_t position = behind ? PositionOf(document, element) + 1 : UINT32_MAX;
  return RunOn(name, path, {element}, [&](Draft& draft, const NodeRules& rules) {
    return InsertNodes(draft, rules, parent, position, fragments);
  });
}

bool TreeEditor::Add(const std::string& xml, const std::string& type, AddWhere where) {
  if (where != AddWhere::kAround) return InsertAll("Add " + type, {xml}, where);
  return Run("Wrap " + What() + " in " + type,
             [&](Draft& draft, const NodeRules& rules) { return Wrap(draft, rules, xml); });
}

std::string TreeEditor::GivenName() const {
  const std::vector<Selected> selection = Selection();
  if (selection.empty()) return {};
  const Document& document = DocumentOf(selection[0].path);
  return std::string(document.AttributeValue(document.element(selection[0].elements[0]), "name"));
}

void TreeEditor::Delete() {
  Run("Delete " + What(), [](Draft& draft, const NodeRules&) { return DeleteNodes(draft); });
}

void TreeEditor::DeleteKeepingChildren() {
  Run("Delete only " + What(), editor::DeleteKeepingChildren);
}

void TreeEditor::MoveAmongSiblings(int by) {
  Run("Move " + What(),
      [by](Draft& draft, const NodeRules&) { return editor::MoveAmongSiblings(draft, by); });
}

void TreeEditor::Promote() { Run("Move " + What() + " out", editor::Promote); }

void TreeEditor::Demote() { Run("Move " + What() + " in", editor::Demote); }

void TreeEditor::ToggleDisabled() {
  bool enable = true;
  for (const Selected& selected : Selection()) {
    for (const ElementIndex element : selected.elements) {
      enable = enable && IsDisabled(DocumentOf(selected.path), element);
    }
  }
  Run((enable ? "Enable " : "Disable ") + What(),
      [](Draft& draft, const NodeRules&) { return editor::ToggleDisabled(draft); });
}

std::string TreeEditor::LostByChange(const std::string& type) const {
  std::string lost;
  if (!CanEdit()) return lost;
  const NodeRules rules = Rules();
  for (const Selected& selected : Selection()) {
    for (const ElementIndex element : selected.elements) {
      for (const std::string& name :
           editor::LostByChange(DocumentOf(selected.path), rules, element, type)) {
        lost += (lost.empty() ? "" : ", ") + name;
      }
    }
  }
  return lost;
}

bool TreeEditor::ChangeType(const std::string& type) {
  return Run("Change " + What() + " to " + type, [&](Draft& draft, const NodeRules& rules) {
    return editor::ChangeType(draft, rules, type);
  });
}

bool TreeEditor::Rename(const std::string& name) {
  return Run(name.empty() ? "Remove the name of " + What() : "Rename " + What() + " to " + name,
             [&](Draft& draft, const NodeRules&) { return editor::SetValue(draft, "name", name); });
}

bool TreeEditor::SetValue(const std::string& attribute, const std::string& value) {
  return Run("Set " + attribute + " of " + What(), [&](Draft& draft, const NodeRules&) {
    return editor::SetValue(draft, attribute, value);
  });
}

bool TreeEditor::ClearValue(const std::string& attribute) {
  return Run("Clear " + attribute + " of " + What(),
             [&](Draft& draft, const NodeRules&) { return editor::ClearValue(draft, attribute); });
}

bool TreeEditor::AddPort(const std::string& name) {
  if (!IsXmlName(name) || IsReservedAttribute(name)) {
    return Refuse("\"" + name + "\" cannot be the name of a port");
  }
  return Run("Add port " + name + " to " + What(), [&](Draft& draft, const NodeRules&) -> Outcome {
    for (const ElementIndex element : draft.selection()) {
      if (draft.document().FindAttribute(draft.document().element(element), name)) {
        return Problem{"there already is a port " + name + " already"};
      }
    }
    return editor::SetValue(draft, name, "");
  });
}

std::string TreeEditor::SelectedText() const {
  std::string text;
  for (const Selected& selected : Selection()) {
    text += CopyText(DocumentOf(selected.path), selected.elements);
  }
  return text;
}

void TreeEditor::SelectAll() {
  TreeView* const view = state_.workspace.view();
  if (!view) return;
  const auto& nodes = view->scene()->nodes;
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].scope == 0) all.push_back(i);
  }
  view->SelectAll(std::move(all));
}

void TreeEditor::Duplicate() {
  Diagnostics diagnostics;
  const std::vector<std::string> fragments = ReadFragments(SelectedText(), diagnostics);
  if (fragments.empty()) {
    Refuse("nothing is selected");
    return;
  }
  InsertAll("Duplicate " + What(), fragments, AddWhere::kAfter);
}

void TreeEditor::Copy() {
  const std::string text = SelectedText();
  if (text.empty()) {
    Refuse("nothing is selected");
    return;
  }
  state_.services.set_clipboard(text);
  state_.Notify("Copied " + What(), now_);
}

void TreeEditor::Cut() {
  if (!Report(CanEdit())) return;
  Copy();
  Run("Cut " + What(), [](Draft& draft, const NodeRules&) { return DeleteNodes(draft); });
}

void TreeEditor::Paste(const std::string& text, AddWhere where) {
  Diagnostics diagnostics;
  const std::vector<std::string> fragments = ReadFragments(text, diagnostics);
  if (diagnostics.has_errors()) {
    state_.OpenPopup(Popup::kPasteErrors);
    state_.popup.problems = diagnostics.all();
    return;
  }
  const std::string what =
      fragments.size() == 1 ? "a node" : std::to_string(fragments.size()) + " nodes";
  InsertAll("Paste " + what, fragments, where);
}

bool TreeEditor::MoveInto(const ElementPlace& parent, std::uint32_t position) {
  const std::vector<Selected> selection = Selection();
  for (const Selected& selected : selection) {
    if (selected.path != parent.path) return Refuse("nodes of another file: cut and paste them");
  }
  const std::string name =
      "Move " + What() + " into " + std::string(NameOf(DocumentOf(parent.path), parent.element));
  return Run(name, [&](Draft& draft, const NodeRules& rules) {
    return editor::MoveInto(draft, rules, parent.element, position);
  });
}

void TreeEditor::Undo() {
  if (const Step* step = state_.workspace.project().Undo()) {
    Show(step->selected_before);
    state_.Notify("Undone: " + step->name, now_);
  } else {
    Refuse("there is nothing to undo");
  }
}

void TreeEditor::Redo() {
  if (const Step* step = state_.workspace.project().Redo()) {
    Show(step->selected_after);
    state_.Notify("Redone: " + step->name, now_);
  } else {
    Refuse("there is nothing to redo");
  }
}

std::vector<std::string> TreeEditor::Disputed() const {
  std::vector<std::string> paths;
  for (const auto& [path, file] : state_.workspace.project().files()) {
    if (file.other) paths.push_back(path);
  }
  return paths;
}

void TreeEditor::TakeTheirs() {
  for (const std::string& path : Disputed()) state_.workspace.project().TakeTheirs(path);
  Show({});
}

void TreeEditor::MergeTheirs() {
  for (const std::string& path : Disputed()) {
    const int kept = state_.workspace.project().MergeTheirs(path);
    if (kept < 0) {
      Refuse("merging would give malformed XML: take theirs or overwrite it");
      return;
    }
    state_.Notify("Merged; mine stayed in " + std::to_string(kept) + " places", now_);
  }
  Show({});
}

}  // namespace coppice::editor
