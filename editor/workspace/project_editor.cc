#include "editor/workspace/project_editor.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "bt_core/engine/compile/sibling_files.h"
#include "bt_core/model/element_edits.h"
#include "bt_core/model/upgrade.h"
#include "bt_core/model/write_file.h"
#include "bt_core/model/xml_text.h"
#include "editor/document/key_names.h"

namespace coppice::editor {
namespace {

constexpr char kNotASubTree[] = "select a SubTree";
constexpr char kEmptyFile[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<root BTCPP_format=\"4\">\n</root>\n";

// The last <BehaviorTree> of the file, or kNoElement.
ElementIndex LastTreeOf(const Document& document) {
  ElementIndex last = kNoElement;
  for (ElementIndex i = document.element(kRootElement).first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    if (document.element(i).tag == "BehaviorTree") last = i;
  }
  return last;
}

// One of them uses trees of the other, or both those of a third one.
bool SharesAFile(const Forest& one, const Forest& other) {
  return std::any_of(one.documents().begin(), one.documents().end(), [&](const Document* mine) {
    return std::any_of(other.documents().begin(), other.documents().end(),
                       [&](const Document* theirs) { return mine->file() == theirs->file(); });
  });
}

}  // namespace

ProjectFiles ProjectEditor::Files() const {
  ProjectFiles files;
  const Workspace& workspace = state_.workspace;
  if (!workspace.file()) return files;
  std::set<std::string> known;
  const auto add = [&](const Forest& forest) {
    for (const Document* document : forest.documents()) {
      const EditedFile* const file = workspace.project().Find(document->file());
      const bool is_new = file && file->document && known.insert(file->path).second;
      if (is_new) files.push_back(*file->document);
    }
  };
  const Forest& shown = *workspace.file()->forest;
  add(shown);
  for (const OpenFile& other : workspace.files()) {
    if (SharesAFile(shown, *other.forest)) add(*other.forest);
  }
  return files;
}

// Not as Change() does: some files of format 3 cannot be edited before.
Outcome ProjectEditor::MakeFormat4(const std::string& path) {
  const EditedFile* const file = state_.workspace.project().Find(path);
  if (!file || !file->document) return Problem{"the text of this file is malformed"};
  const OpenFile* const shown = state_.workspace.file();
  const Project* const project = shown ? shown->forest->project().get() : nullptr;
  Diagnostics told;  // what cannot be upgraded is in the list of problems already
  FileChange part;
  part.path = path;
  part.steps = {
      UpgradeToFormat4(*file->document, told, project ? project->TreesUsedByName() : TreeNames())};
  NamedChange change;
  change.name = "Make it format 4";
  change.files.push_back(std::move(part));
  Diagnostics diagnostics;
  if (!state_.workspace.project().Do(std::move(change), edit_.SelectedPlaces(), diagnostics)) {
    return Problem{diagnostics.all().empty() ? "not possible" : diagnostics.all()[0].message};
  }
  state_.workspace.Refresh(now_);
  return {};
}

Outcome ProjectEditor::Change(const std::string& name, const ProjectFiles& files,
                              const std::vector<Edit>& edits) {
  if (Outcome can = edit_.CanEdit(); !can) return can;
  NamedChange change;
  change.name = name;
  std::vector<FilePlace> before = edit_.SelectedPlaces();
  std::vector<FilePlace> after = before;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (edits[i].empty()) continue;
    FileChange part;
    part.path = files[i].file();
    part.steps = {edits[i]};
    for (FilePlace& place : after) {
      if (place.path != part.path) continue;
      place.offset = MapOffset(edits[i], place.offset);
      part.selected.push_back(place.offset);
    }
    change.files.push_back(std::move(part));
  }
  Diagnostics diagnostics;
  if (!state_.workspace.project().Do(std::move(change), std::move(before), diagnostics)) {
    return Problem{diagnostics.all().empty() ? "not possible" : diagnostics.all()[0].message};
  }
  state_.workspace.Refresh(now_);
  state_.workspace.SelectPlaces(after, now_);
  state_.Notify(name, now_);
  return {};
}

Outcome ProjectEditor::CheckId(const std::string& id) const {
  if (id.empty()) return Problem{"a tree needs a name"};
  if (!TreesCalled(Files(), id).empty()) return Problem{"there is a tree " + id + " already"};
  return {};
}

Outcome ProjectEditor::Extract(const std::string& id) {
  if (Outcome free = CheckId(id); !free) return free;
  const ProjectFiles files = Files();
  return edit_.Try("Extract " + id, [&](Draft& draft, const NodeRules& rules) -> Outcome {
    if (draft.selection().empty()) return Problem{"nothing is selected"};
    const ElementIndex tree = TreeOf(draft.document(), draft.selection().front());
    if (tree == kNoElement) return Problem{"nothing is selected"};
    const std::string_view own =
        draft.document().AttributeValue(draft.document().element(tree), "ID");
    return ExtractSubTree(draft, rules, id, CallersOf(files, own));
  });
}

Outcome ProjectEditor::Inline() {
  const ProjectFiles files = Files();
  return edit_.Try("Inline", [&](Draft& draft, const NodeRules& rules) -> Outcome {
    const std::vector<ElementIndex> selection = draft.selection();
    if (selection.size() != 1) return Problem{kNotASubTree};
    const std::string_view id = TypeOf(draft.document(), selection[0]);
    const std::vector<ElementIn> trees = TreesCalled(files, id);
    if (draft.document().element(selection[0]).tag != "SubTree") return Problem{kNotASubTree};
    if (trees.empty()) return Problem{"there is no tree " + std::string(id)};
    return InlineSubTree(draft, rules, files[trees[0].file], trees[0].element);
  });
}

Outcome ProjectEditor::NewTree(const std::string& id) {
  if (Outcome free = CheckId(id); !free) return free;
  const std::optional<ElementPlace> shown = state_.workspace.ShownTree();
  if (!shown) return edit_.CanEdit();
  const ProjectFiles files = Files();
  std::vector<Edit> edits(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].file() != shown->path) continue;
    const ElementIndex last = LastTreeOf(files[i]);
    const std::uint32_t position = last == kNoElement ? 0 : PositionOf(files[i], last) + 1;
    edits[i] = InsertElement(files[i], kRootElement, position,
                             "<BehaviorTree ID=\"" + EscapeXmlValue(id, '"') + "\"/>");
  }
  Outcome made = Change("New tree " + id, files, edits);
  if (made) ShowTree(id);
  return made;
}

Outcome ProjectEditor::DeleteTree() {
  const std::optional<ElementPlace> shown = state_.workspace.ShownTree();
  if (!shown) return edit_.CanEdit();
  const std::string id = state_.workspace.ShownTreeId();
  const ProjectFiles files = Files();
  const std::size_t uses = SubTreesOf(files, id).size();
  if (uses > 0) {
    return Problem{id + " is used in " + std::to_string(uses) + (uses == 1 ? " place" : " places")};
  }
  std::vector<Edit> edits(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].file() == shown->path) edits[i] = RemoveElement(files[i], shown->element);
  }
  return Change("Delete tree " + id, files, edits);
}

Outcome ProjectEditor::RenameTree(const std::string& id) {
  const std::string old = state_.workspace.ShownTreeId();
  if (old.empty()) return edit_.CanEdit();
  if (Outcome free = id == old ? Outcome() : CheckId(id); !free) return free;
  const ProjectFiles files = Files();
  Outcome renamed =
      Change("Rename " + old + " to " + id, files, editor::RenameTree(files, old, id));
  if (renamed) ShowTree(id);
  return renamed;
}

Outcome ProjectEditor::Include(const std::string& path) {
  const std::optional<ElementPlace> shown = state_.workspace.ShownTree();
  if (!shown) return edit_.CanEdit();
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::absolute(shown->path, error).parent_path();
  const fs::path whole = folder / path;
  const std::string written = whole.lexically_proximate(folder).string();
  if (path.empty()) return Problem{"a file needs a name"};
  if (!fs::exists(whole, error)) {
    Diagnostics diagnostics;
    if (!WriteFile(whole.string(), kEmptyFile, diagnostics))
      return Problem{diagnostics.all()[0].message};
  }
  const ProjectFiles files = Files();
  std::vector<Edit> edits(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].file() != shown->path) continue;
    edits[i] = InsertElement(files[i], kRootElement, 0,
                             "<include path=\"" + EscapeXmlValue(written, '"') + "\"/>");
  }
  return Change("Include " + written, files, edits);
}

std::vector<std::string> ProjectEditor::SelectedKeys() const {
  std::vector<std::string> keys;
  for (const FilePlace& place : edit_.SelectedPlaces()) {
    const Document& document = *state_.workspace.project().Find(place.path)->document;
    const ElementIndex element = document.ElementAt(place.offset);
    for (const KeyName& name : KeyNamesIn(document, Models(), element)) {
      const bool known = std::find(keys.begin(), keys.end(), name.key) != keys.end();
      if (name.element == element && !name.is_global && !known) keys.push_back(name.key);
    }
  }
  return keys;
}

Outcome ProjectEditor::RenameKey(const std::string& key, const std::string& to) {
  const std::vector<FilePlace> places = edit_.SelectedPlaces();
  if (places.empty()) return Problem{"nothing is selected"};
  if (key == to) return {};
  const ProjectFiles files = Files();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].file() != places[0].path) continue;
    const ElementIndex tree = TreeOf(files[i], files[i].ElementAt(places[0].offset));
    const auto edits = editor::RenameKey(files, Models(), {i, tree}, key, to);
    if (!edits) return Problem{edits.problem()};
    return Change("Rename key " + key + " to " + to, files, *edits);
  }
  return Problem{"nothing is selected"};
}

Outcome ProjectEditor::ReplaceAll(const std::vector<Match>& matches, const Query& query,
                                  const std::string& with) {
  const ProjectFiles files = Files();
  return Change("Replace in " + std::to_string(matches.size()) + " places", files,
                editor::Replace(files, matches, query, with));
}

void ProjectEditor::GoTo(const std::string& path, std::uint32_t offset) {
  state_.workspace.SelectPlaces({{path, offset}}, now_);
  if (TreeView* view = state_.workspace.view()) view->RevealReadable(state_.screen.canvas_size);
}

std::string ProjectEditor::TreeAroundSelection() const {
  const TreeView* view = std::as_const(state_).workspace.file() ? state_.workspace.view() : nullptr;
  if (!view || view->selected() == kNoSceneNode) return {};
  const auto& nodes = view->scene()->nodes;
  std::uint32_t node = view->selected();
  const std::uint32_t scope = nodes[node].scope;
  if (scope == 0) return view->scene()->tree_id;
  while (nodes[node].scope == scope) node = nodes[node].parent;
  return std::string(nodes[node].id);
}

bool ProjectEditor::ShowTree(const std::string& id) {
  Workspace& workspace = state_.workspace;
  if (!workspace.file()) return false;
  const auto& files = workspace.files();
  const auto number = static_cast<std::size_t>(workspace.file() - files.data());
  const Forest& forest = *workspace.forest();
  const int tree = forest.Find(id);
  if (tree < 0) return false;
  const std::uint32_t document = forest.trees()[static_cast<std::size_t>(tree)].document;
  const auto own = std::find_if(files.begin(), files.end(), [&](const OpenFile& file) {
    return document >= forest.own_documents() && file.path == forest.documents()[document]->file();
  });
  if (own == files.end()) {
    workspace.ShowFileTree(number, tree, now_);
  } else {
    workspace.ShowFileTree(static_cast<std::size_t>(own - files.begin()), own->forest->Find(id),
                           now_);
  }
  return true;
}

Outcome ProjectEditor::GoToDefinition() {
  const std::vector<FilePlace> places = edit_.SelectedPlaces();
  if (places.size() != 1) return Problem{kNotASubTree};
  const Document& document = *state_.workspace.project().Find(places[0].path)->document;
  const ElementIndex element = document.ElementAt(places[0].offset);
  const std::string id(TypeOf(document, element));
  if (document.element(element).tag.substr(0, 7) != "SubTree") return Problem{kNotASubTree};
  if (ShowTree(id) || OpenTreeBeside(document.file(), id)) return {};
  return Problem{"there is no tree " + id};
}

// Many projects have a file for each tree, which include nothing: the robot reads them all.
bool ProjectEditor::OpenTreeBeside(const std::string& path, const std::string& id) {
  const std::string file = SiblingFiles().FindTree(path, id);
  if (file.empty()) return false;
  state_.workspace.Open((std::filesystem::path(path).parent_path() / file).string(), now_);
  return ShowTree(id);
}

}  // namespace coppice::editor
