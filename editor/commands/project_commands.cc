#include "editor/commands/project_commands.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "editor/document/key_names.h"
#include "editor/keys/fuzzy.h"
#include "editor/workspace/file_dialog.h"
#include "editor/workspace/project_editor.h"

namespace coppice::editor {
namespace {

constexpr std::size_t kRows = 18;

// Matches that are not to be replaced, by place.
using Skipped = std::set<std::pair<std::size_t, std::uint32_t>>;

class ProjectCommands {
 public:
  explicit ProjectCommands(EditorState& state) : state_(state) {}

  void AddAll() {
    AddTrees();
    AddKeys();
    AddSearch();
    AddHistory();
    AddModels();
  }

 private:
  using Run = std::function<Outcome(ProjectEditor&)>;

  void Add(std::string id, std::string title, KeyChord keys, std::function<void()> run) {
    state_.commands.Add({std::move(id), std::move(title), keys, std::move(run)});
  }

  void AddDoing(std::string id, std::string title, KeyChord keys, Run run) {
    Add(std::move(id), std::move(title), keys, [&s = state_, run = std::move(run)] {
      ProjectEditor edit(s, s.now);
      if (const Outcome done = run(edit); !done) s.Notify(done.problem(), s.now, true);
    });
  }

  void AddAsking(std::string id, std::string title, KeyChord keys, std::string hint,
                 std::function<std::string(EditorState&)> first,
                 std::function<Outcome(ProjectEditor&, const std::string&)> run) {
    AddDoing(std::move(id), std::move(title), keys,
             [&s = state_, hint, first, run](ProjectEditor&) {
               Outcome can = TreeEditor(s, s.now).CanEdit();
               if (!can) return can;
               s.Ask({hint,
                      [&s, run](const std::string& text) {
                        ProjectEditor edit(s, s.now);
                        return run(edit, text);
                      },
                      {}},
                     first ? first(s) : "");
               return can;
             });
  }

  void AddTrees() {
    AddAsking(
        "tree.extract", "Extract a SubTree", {'E', kCtrl}, "Name of the new tree",
        [](EditorState& s) { return TreeEditor(s, 0).GivenName(); },
        [](ProjectEditor& edit, const std::string& id) { return edit.Extract(id); });
    AddDoing("tree.inline", "Inline the SubTree", {'E', kCtrl | kShift},
             [](ProjectEditor& edit) { return edit.Inline(); });
    AddAsking("tree.new", "New tree", {'T', kCtrl}, "Name of the new tree", {},
              [](ProjectEditor& edit, const std::string& id) { return edit.NewTree(id); });
    AddAsking(
        "tree.rename", "Rename the tree everywhere", {kKeyF1 + 1, kCtrl},
        "New name of the tree, wherever it is used",
        [](EditorState& s) { return s.workspace.ShownTreeId(); },
        [](ProjectEditor& edit, const std::string& id) { return edit.RenameTree(id); });
    AddDoing("tree.delete", "Delete the tree", {},
             [](ProjectEditor& edit) { return edit.DeleteTree(); });
    Add("file.include", "Include a file", {}, [&s = state_] {
      OpenPickDialog(s, "Include a file, or make it", [&s](const std::string& path) -> Outcome {
        if (path.empty()) return Problem{"a file needs a name"};
        return ProjectEditor(s, s.now).Include(std::filesystem::absolute(path).string());
      });
    });
    AddDoing("tree.definition", "Go to the tree of the SubTree", {kKeyF1 + 11},
             [](ProjectEditor& edit) { return edit.GoToDefinition(); });
    AddDoing("tree.usages", "Find usages", {kKeyF1 + 11, kShift},
             [this_ = *this](ProjectEditor& edit) { return this_.ShowUsages(edit); });
    AddDoing("tree.places", "Places that use the tree of the node", {},
             [this_ = *this](ProjectEditor& edit) {
               return this_.ShowUsages(edit, edit.TreeAroundSelection());
             });
  }

  // Of the selected SubTree's tree, of the type of the selected node, or of the shown tree.
  Outcome ShowUsages(ProjectEditor& edit) const {
    const TreeView* view = state_.workspace.view();
    std::string id = state_.workspace.ShownTreeId();
    if (view && view->selected() != kNoSceneNode) id = view->scene()->nodes[view->selected()].id;
    return ShowUsages(edit, id);
  }

  Outcome ShowUsages(ProjectEditor& edit, const std::string& id) const {
    if (id.empty()) return Problem{"nothing is selected"};
    std::vector<Choice> rows;
    const ProjectFiles files = edit.Files();
    for (std::size_t f = 0; f < files.size(); ++f) {
      for (ElementIndex i{0}; i < files[f].elements().size(); ++i) {
        if (IsNode(files[f], i) && TypeOf(files[f], i) == id) rows.push_back(RowOf(files[f], i));
      }
    }
    if (rows.empty()) return Problem{id + " is not used"};
    Offer("Usages of " + id, std::move(rows));
    return {};
  }

  Choice RowOf(const Document& document, ElementIndex element) const {
    const std::uint32_t offset = document.element(element).offset;
    const SourceLocation where = document.Location(offset);
    const ElementIndex tree = TreeOf(document, element);
    Choice row;
    row.title = std::string(NameOf(document, element));
    row.note = std::string(document.AttributeValue(document.element(tree), "ID")) + "   " +
               where.file.substr(where.file.rfind('/') + 1) + ":" + std::to_string(where.line);
    row.run = [&s = state_, path = document.file(), offset] {
      ProjectEditor(s, s.now).GoTo(path, offset);
    };
    return row;
  }

  void Offer(std::string hint, std::vector<Choice> rows) const {
    state_.Offer({std::move(hint), [rows = std::move(rows)](const std::string& typed) {
                    std::vector<Choice> fitting;
                    for (const Choice& row : rows) {
                      if (FuzzyScore(typed, row.title) > 0) fitting.push_back(row);
                      if (fitting.size() == kRows) break;
                    }
                    return fitting;
                  }});
  }

  void AddKeys() {
    AddDoing("key.rename", "Rename a key everywhere", {'K', kCtrl | kShift},
             [this_ = *this](ProjectEditor& edit) { return this_.ChooseKey(edit); });
  }

  Outcome ChooseKey(ProjectEditor& edit) const {
    if (Outcome can = TreeEditor(state_, state_.now).CanEdit(); !can) return can;
    const std::vector<std::string> keys = edit.SelectedKeys();
    if (keys.empty()) return Problem{"select a node that uses a key"};
    if (keys.size() == 1) {
      AskKey(keys[0]);
      return {};
    }
    std::vector<Choice> rows;
    for (const std::string& key : keys) {
      Choice row;
      row.title = key;
      row.run = [this_ = *this, key] { this_.AskKey(key); };
      rows.push_back(std::move(row));
    }
    Offer("Rename a key: which", std::move(rows));
    return {};
  }

  void AskKey(const std::string& key) const {
    state_.Ask({"New name of the key " + key,
                [&s = state_, key](const std::string& to) {
                  return ProjectEditor(s, s.now).RenameKey(key, to);
                },
                {}},
               key);
  }

  // The newest step first; choosing one goes back or forth to behind it.
  void AddHistory() {
    Add("edit.history", "History", {'H', kCtrl | kShift}, [this_ = *this] {
      const History& history = this_.state_.workspace.project().history();
      std::vector<Choice> rows;
      for (std::size_t i = history.steps().size(); i > 0; --i) {
        Choice row = this_.HistoryRow(history.steps()[i - 1].name, i);
        row.kind = i == history.done() ? "now" : i > history.done() ? "undone" : "done";
        rows.push_back(std::move(row));
      }
      rows.push_back(this_.HistoryRow("as it was opened", 0));
      rows.back().kind = history.done() == 0 ? "now" : "done";
      this_.Offer("History: Enter goes back or forth to the chosen step", std::move(rows));
    });
  }

  Choice HistoryRow(const std::string& title, std::size_t step) const {
    Choice row;
    row.title = title;
    row.note = std::to_string(step);
    row.run = [&s = state_, step] {
      const History& history = s.workspace.project().history();
      TreeEditor edit(s, s.now);
      while (history.done() > step) edit.Undo();
      while (history.done() < step) edit.Redo();
    };
    return row;
  }

  void AddModels() {
    Add("file.models", "Load node models", {}, [&s = state_] {
      OpenPickDialog(
          s, "Load node models: a file with <TreeNodesModel>, as \"coppice nodes\" writes it",
          [&s](const std::string& path) -> Outcome {
            const std::size_t before = s.workspace.model_files().size();
            s.workspace.AddModels(path);
            s.workspace.RenewAll(s.now);
            if (s.workspace.model_files().size() > before) return {};
            return Problem{s.workspace.model_problems().back().message};
          });
    });
  }

  void AddSearch() {
    Add("edit.find", "Find", {'F', kCtrl}, [this_ = *this] {
      this_.state_.Offer({"Find; type: name: port: value: key: narrow it, /.../ is a pattern",
                          [this_](const std::string& typed) { return this_.Find(typed); }},
                         this_.state_.recent.search);
    });
    AddDoing("edit.find_next", "Find next", {kKeyF1 + 2},
             [this_ = *this](ProjectEditor& edit) { return this_.FindNext(edit, +1); });
    AddDoing("edit.find_previous", "Find previous", {kKeyF1 + 2, kShift},
             [this_ = *this](ProjectEditor& edit) { return this_.FindNext(edit, -1); });
    AddDoing("edit.replace", "Replace", {'H', kCtrl},
             [this_ = *this](ProjectEditor&) { return this_.AskWhat(); });
  }

  // From the selected node on, in the order of the files, and round the end.
  Outcome FindNext(ProjectEditor& edit, int by) const {
    const Expected<Query> query = ParseQuery(state_.recent.search);
    if (!query || !state_.workspace.file()) return Problem{"nothing was searched: Ctrl+F"};
    const ProjectFiles files = edit.Files();
    std::vector<FilePlace> hits;
    for (const Match& match : Search(files, *state_.workspace.file()->models, *query)) {
      FilePlace hit{files[match.file].file(), files[match.file].element(match.element).offset};
      if (hits.empty() || !(hits.back() == hit)) hits.push_back(std::move(hit));
    }
    if (hits.empty()) return Problem{"\"" + state_.recent.search + "\" was not found"};
    const std::vector<FilePlace> selected = TreeEditor(state_, state_.now).SelectedPlaces();
    const auto at =
        selected.empty() ? hits.end() : std::find(hits.begin(), hits.end(), selected[0]);
    const std::size_t count = hits.size();
    const std::size_t last = by > 0 ? count - 1 : 0;
    const std::size_t from = at == hits.end() ? last : static_cast<std::size_t>(at - hits.begin());
    const FilePlace& next = hits[(from + count + static_cast<std::size_t>(by)) % count];
    edit.GoTo(next.path, next.offset);
    return {};
  }

  std::vector<Choice> Find(const std::string& typed) const {
    state_.recent.search = typed;
    const Expected<Query> query = ParseQuery(typed);
    std::vector<Choice> rows;
    if (!query || !state_.workspace.file()) return rows;
    const ProjectFiles files = ProjectEditor(state_, state_.now).Files();
    for (const Match& match : Search(files, *state_.workspace.file()->models, *query, kRows)) {
      Choice row = RowOf(files[match.file], match.element);
      row.kind = ToString(match.role);
      row.title = TitleOf(match, match.before);
      rows.push_back(std::move(row));
    }
    return rows;
  }

  static std::string TitleOf(const Match& match, const std::string& text) {
    const bool is_value = match.role == TextRole::kValue || match.role == TextRole::kKey;
    return is_value ? match.attribute + "=\"" + text + "\"" : text;
  }

  Outcome AskWhat() const {
    if (Outcome can = TreeEditor(state_, state_.now).CanEdit(); !can) return can;
    state_.Ask({"Replace what; type: name: port: value: narrow it, /.../ is a pattern",
                [this_ = *this](const std::string& typed) { return this_.AskWith(typed); },
                [this_ = *this](const std::string& typed) { return this_.Find(typed); }},
               state_.recent.search);
    return {};
  }

  Outcome AskWith(const std::string& typed) const {
    const Expected<Query> query = ParseQuery(typed);
    if (!query) return Problem{query.problem()};
    if (query->is_for_keys()) return Problem{"\"Rename a key everywhere\" does that"};
    const ProjectFiles files = ProjectEditor(state_, state_.now).Files();
    const std::vector<Match> matches = Search(files, *state_.workspace.file()->models, *query);
    if (matches.empty()) return Problem{"not found"};
    const auto skipped = std::make_shared<Skipped>();
    state_.Ask(
        {"Replace it in " + std::to_string(matches.size()) +
             (matches.size() == 1 ? " place" : " places") + " with; click to leave one out",
         [=, this_ = *this](const std::string& with) {
           std::vector<Match> wanted = matches;
           wanted.erase(std::remove_if(wanted.begin(), wanted.end(),
                                       [&](const Match& m) {
                                         return skipped->count({m.file, m.offset}) > 0;
                                       }),
                        wanted.end());
           return ProjectEditor(this_.state_, this_.state_.now).ReplaceAll(wanted, *query, with);
         },
         [=](const std::string& with) {
           std::vector<Choice> rows;
           for (const Match& match : matches) {
             if (rows.size() == kRows) break;
             const bool skip = skipped->count({match.file, match.offset}) > 0;
             Choice row;
             row.title = TitleOf(match, match.before) +
                         (skip ? "" : "  ->  " + Replaced(match, *query, with));
             row.kind = skip ? "leave" : ToString(match.role);
             row.run = [skipped, match] {
               const auto place = std::make_pair(match.file, match.offset);
               if (skipped->erase(place) == 0) skipped->insert(place);
             };
             rows.push_back(std::move(row));
           }
           return rows;
         }});
    return {};
  }

  EditorState& state_;
};

}  // namespace

void AddProjectCommands(EditorState& state) { ProjectCommands(state).AddAll(); }

}  // namespace coppice::editor
