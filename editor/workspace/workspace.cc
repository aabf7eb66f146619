// What is slow waits: a scene is built for the shown tree alone, and the engine's checker, which
// compiles whole files, speaks a moment after the last change. Until then its last words stand, and
// a file that is malformed while the user types keeps the tree that it had.
#include "editor/workspace/workspace.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <unordered_set>
#include <utility>

#include "bt_core/engine/compile/check_project.h"
#include "bt_core/engine/compile/model_registry.h"
#include "editor/document/shown_problems.h"
#include "editor/files/linked_project.h"
#include "editor/live/record_source.h"

namespace coppice::editor {
namespace {

constexpr double kCheckDelay = 0.05;   // seconds: a burst of changes is checked once
constexpr double kLookDelay = 1;       // between two looks at the disk
constexpr double kRefreshDelay = 0.5;  // between two looks whether a record has grown

void AddOnce(std::vector<Diagnostic>& all, const std::vector<Diagnostic>& more) {
  std::unordered_set<std::string> known;
  for (const Diagnostic& one : all) known.insert(ToString(one));
  for (const Diagnostic& one : more) {
    if (known.insert(ToString(one)).second) all.push_back(one);
  }
}

// By what was loaded, what robots say and what the files say.
std::shared_ptr<const NodeModels> ModelsOf(const Forest& forest, const std::vector<Project>& loaded,
                                           const std::vector<Project>& of_robots) {
  std::vector<const Document*> given;
  for (const Project& project : loaded) {
    for (const Document& document : project.documents()) given.push_back(&document);
  }
  for (const Project& project : of_robots) given.push_back(&project.documents().front());
  return std::make_shared<const NodeModels>(ModelsFor(given, forest.documents()));
}

// The files that are linked with it say theirs themselves.
std::vector<Diagnostic> ProblemsOfItsOwn(const Forest& forest, std::vector<Diagnostic> problems) {
  std::unordered_set<std::string> others;
  for (std::size_t i = forest.own_documents(); i < forest.documents().size(); ++i) {
    others.insert(forest.documents()[i]->file());
  }
  const auto is_of_others = [&](const Diagnostic& one) { return others.count(one.where.file) > 0; };
  problems.erase(std::remove_if(problems.begin(), problems.end(), is_of_others), problems.end());
  return problems;
}

// What a text says about node types, as a file of its own.
std::string ModelsOf(const Document& document) {
  std::string text = "<root BTCPP_format=\"4\">";
  for (const Element& element : document.elements()) {
    if (element.tag != "TreeNodesModel") continue;
    text += document.text().substr(element.offset, element.end - element.offset);
  }
  return text + "</root>";
}

}  // namespace

OpenFile Workspace::Load(const std::string& path) {
  OpenFile file;
  file.path = path;
  Diagnostics diagnostics;
  std::optional<LinkedProject> linked = ReadLinked(project_, path, diagnostics);
  file.forest = std::make_shared<const Forest>(
      linked ? Forest::FromProject(std::move(linked->project), linked->own_documents,
                                   linked->main_tree)
             : Forest());
  file.read_problems = diagnostics.all();
  file.models = ModelsOf(*file.forest, model_projects_, run_models_);
  const EditedFile* edited = project_.Find(path);
  file.problems = ShownProblems(file.read_problems, edited && edited->is_new);
  if (edited && !edited->document) file.text = edited->text;
  return file;
}

bool Workspace::OpenRecord(const std::string& path) {
  int run = FindRun(path);
  if (run < 0) {
    Diagnostics diagnostics;
    std::unique_ptr<RecordSource> record = RecordSource::Open(path, diagnostics);
    AddOnce(record_problems_, diagnostics.all());
    if (!record) return false;
    AddRun(std::move(record));
    run = static_cast<int>(runs_.size() - 1);
  }
  ShowRun(Index(run));
  return true;
}

bool Workspace::Open(const std::string& path, double now) {
  if (IsRecordName(path)) return OpenRecord(path);
  look_at_ = std::min(look_at_, now + kLookDelay);
  std::size_t at = 0;
  while (at < files_.size() && files_[at].path != path) ++at;
  if (at < files_.size()) {
    Reload(now);
    const int main = files_[at].forest->main_tree();
    if (file_ != static_cast<int>(at)) ShowFileTree(at, main, now);
    return main >= 0;
  }
  Add(path, now);
  check_at_ = now;  // the tree is shown first
  const int main = files_[at].forest->main_tree();
  ShowFileTree(at, main, now);
  return main >= 0;
}

void Workspace::OpenBehind(const std::string& path, double now) {
  const bool is_open = std::any_of(files_.begin(), files_.end(),
                                   [&](const OpenFile& file) { return file.path == path; });
  if (is_open) return;
  Add(path, now);
  look_at_ = std::min(look_at_, now + kLookDelay);
  check_at_ = std::min(check_at_, now);
}

// Those whose trees were missing have them now.
void Workspace::Add(const std::string& path, double now) {
  files_.push_back(Load(path));
  shown_version_ = project_.version();
  const std::string shown = ShownTreeId();
  std::unordered_set<std::string> added;
  for (const TreeEntry& tree : files_.back().forest->trees()) added.insert(tree.id);
  for (std::size_t at = 0; at + 1 < files_.size(); ++at) {
    const std::shared_ptr<const Project>& project = files_[at].forest->project();
    if (!project) continue;
    const std::set<std::string> missing = MissingTrees(*project);
    const bool gains = std::any_of(missing.begin(), missing.end(),
                                   [&](const std::string& id) { return added.count(id) > 0; });
    if (!gains) continue;
    Renew(at);
    if (file_ == static_cast<int>(at)) ShowFileTree(at, files_[at].forest->Find(shown), now);
  }
}

std::string Workspace::New(double now) {
  std::string path = "untitled.xml";
  std::error_code error;
  for (int i = 2; project_.Find(path) || std::filesystem::exists(path, error); ++i) {
    path = "untitled-" + std::to_string(i) + ".xml";
  }
  Create(path, now);
  return path;
}

void Workspace::Create(const std::string& path, double now) {
  project_.Create(path,
                  "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                  "<root BTCPP_format=\"4\" main_tree_to_execute=\"MainTree\">\n"
                  "  <BehaviorTree ID=\"MainTree\"/>\n"
                  "</root>\n");
  Open(path, now);
}

// Scenes keep what they point into alive, and are renewed when they are shown.
void Workspace::Renew(std::size_t at) {
  OpenFile loaded = Load(files_[at].path);
  if (loaded.forest->trees().empty() && !loaded.text.empty() &&
      !files_[at].forest->trees().empty()) {
    loaded.forest = files_[at].forest;
    loaded.models = files_[at].models;
    loaded.is_stale = true;
  }
  // What the checker said holds until it speaks again, or the list would flicker.
  if (!loaded.is_stale) AddOnce(loaded.problems, files_[at].problems);
  files_[at] = std::move(loaded);
}

void Workspace::Refresh(double now) {
  if (project_.version() == shown_version_) return;
  LoadAll(now);
  check_at_ = std::min(check_at_, now + kCheckDelay);
}

void Workspace::LoadAll(double now) {
  const std::string shown =
      file_ >= 0 && tree_ >= 0 ? forest()->trees()[Index(tree_)].id : std::string();
  for (std::size_t at = 0; at < files_.size(); ++at) Renew(at);
  shown_version_ = project_.version();
  if (file_ < 0) return;
  const Forest& forest = *files_[Index(file_)].forest;
  const int same = forest.Find(shown);
  ShowFileTree(Index(file_), same >= 0 ? same : forest.main_tree(), now);
}

void Workspace::Rename(const std::string& path, const std::string& new_path) {
  for (OpenFile& file : files_) {
    if (file.path == path) file.path = new_path;
  }
  const std::string prefix = "file:" + path + ":";
  std::map<std::string, std::unique_ptr<TreeView>> views;
  for (auto& [key, view] : views_) {
    const bool moved = key.compare(0, prefix.size(), prefix) == 0;
    views[moved ? "file:" + new_path + ":" + key.substr(prefix.size()) : key] = std::move(view);
  }
  views_ = std::move(views);
}

void Workspace::CheckNow() {
  if (check_at_ != kNever) CheckAll();
}

// The engine's own checker, with what the files say about node types.
void Workspace::CheckAll() {
  check_at_ = kNever;
  for (OpenFile& file : files_) {
    if (!file.forest->project() || file.is_stale) continue;
    Diagnostics diagnostics;
    auto registry = std::make_shared<Registry>();
    for (const Project& models : run_models_) coppice::AddModels(models, *registry);
    for (const Project& models : model_projects_) coppice::AddModels(models, *registry);
    coppice::AddModels(*file.forest->project(), *registry);
    CheckProject(file.forest->project(), registry, {}, diagnostics);
    std::vector<Diagnostic> problems = file.read_problems;
    AddOnce(problems, ProblemsOfItsOwn(*file.forest, diagnostics.all()));
    const EditedFile* edited = project_.Find(file.path);
    file.problems = ShownProblems(problems, edited && edited->is_new);
  }
}

double Workspace::NextUpdateIn(double now) const {
  return std::max(std::min({check_at_, look_at_, refresh_at_}) - now, 0.0);
}

void Workspace::AddModels(const std::string& path) {
  Diagnostics diagnostics;
  std::optional<Project> project = Project::FromFile(path, diagnostics);
  if (project) {
    for (const Document& document : project->documents()) models_.AddFrom(document);
    model_projects_.push_back(*std::move(project));
  }
  AddOnce(model_problems_, diagnostics.all());
}

std::vector<std::string> Workspace::model_files() const {
  std::vector<std::string> files;
  for (const Project& project : model_projects_) {
    files.push_back(project.documents().front().file());
  }
  return files;
}

void Workspace::LookAtDisk(double now) {
  for (const std::string& path : project_.LookAtDisk()) {
    const EditedFile& file = *project_.Find(path);
    const std::string name = path.substr(path.rfind('/') + 1);
    if (file.is_gone) {
      news_ = name + " has been removed from the disk: this is the only copy, Ctrl+S writes it";
    } else if (file.other) {
      news_ =
          name +
          " was changed on the disk in the same places as here: \"resolve\" asks which version to "
          "keep";
    } else if (file.is_dirty()) {
      news_ = name + " was changed on the disk and merged with what is not saved here";
    } else {
      news_ = name + " was changed on the disk and read again";
    }
  }
  Refresh(now);
}

void Workspace::Reload(double now) {
  LookAtDisk(now);
  CheckNow();
}

void Workspace::AddRun(std::unique_ptr<RunSource> source) {
  runs_.push_back(
      std::make_unique<RunView>(std::move(source), std::make_shared<const NodeModels>(models_)));
  if (runs_.back()->source().may_grow()) refresh_at_ = 0;
  if (runs_.size() == 1) ShowRun(0);
}

void Workspace::CloseRun(std::size_t run, double now) {
  if (run >= runs_.size()) return;
  const std::string key = "run:" + runs_[run]->name();
  runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(run));
  if (const auto view = views_.find(key); view != views_.end()) {
    if (view_ == view->second.get()) view_ = nullptr;
    alive_.erase(view->second.get());
    views_.erase(view);
  }
  if (run_ < static_cast<int>(run)) return;
  --run_;
  if (run_ >= 0) return;
  if (!runs_.empty()) {
    run_ = 0;
  } else if (!files_.empty()) {
    ShowFileTree(0, files_[0].forest->main_tree(), now);
  }
}

int Workspace::FindRun(const std::string& name) const {
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (runs_[i]->name() == name) return static_cast<int>(i);
  }
  return -1;
}

bool Workspace::Update(double now) {
  const std::uint64_t version = shown_version_;
  const bool checked = now >= check_at_;
  if (now >= look_at_) {
    look_at_ = now + kLookDelay;
    LookAtDisk(now);
  }
  if (now >= check_at_) {
    CheckAll();
    project_.ReadAhead();
  }
  if (now >= refresh_at_) RefreshRecords(now);
  for (const auto& run : runs_) run->Update(hooks, now);
  RemoveReachedStops();
  LearnFromRuns(now);
  if (run_ >= 0) ShowTreeOfRun(now);
  return checked || version != shown_version_ || !news_.empty() || !runs_.empty();
}

// A record may still be written.
void Workspace::RefreshRecords(double now) {
  refresh_at_ = kNever;
  for (const auto& run : runs_) {
    if (!run->source().may_grow()) continue;
    run->source().Refresh();
    refresh_at_ = now + kRefreshDelay;
  }
}

// "Run to here" stops once.
void Workspace::RemoveReachedStops() {
  std::vector<std::uint32_t> reached;
  for (const WantedHook& wanted : hooks.all()) {
    if (!IsBreakpoint(wanted.hook) || wanted.hook.times == 0) continue;
    const bool stopped = std::any_of(runs_.begin(), runs_.end(), [&](const auto& run) {
      const SetHookState* set = run->hooks().Find(wanted.number);
      return set && set->hits >= wanted.hook.times;
    });
    if (stopped) reached.push_back(wanted.number);
  }
  for (const std::uint32_t number : reached) hooks.Remove(number);
}

// Robots say which node types they have: files are edited and checked with them.
void Workspace::LearnFromRuns(double now) {
  std::vector<const RunTree*> trees;
  for (const auto& run : runs_) {
    if (run->tree()) trees.push_back(run->tree().get());
  }
  if (trees == learned_from_) return;
  learned_from_ = std::move(trees);
  run_models_.clear();
  for (const auto& run : runs_) {
    if (!run->tree()) continue;
    for (const Document* document : run->tree()->forest().documents()) {
      Diagnostics ignored;  // the run's own view speaks of them
      auto models = Project::FromText(ModelsOf(*document), run->name(), ignored);
      if (models) run_models_.push_back(*std::move(models));
    }
  }
  RenewAll(now);
}

void Workspace::RenewAll(double now) {
  LoadAll(now);
  check_at_ = std::min(check_at_, now);
}

void Workspace::ShowTreeOfRun(double now) {
  const std::shared_ptr<const RunTree>& tree = run()->tree();
  if (!tree) {
    view_ = nullptr;
    tree_ = -1;
    return;
  }
  tree_ = tree->forest().main_tree();
  const std::string key = "run:" + run()->name();
  const auto known = views_.find(key);
  const bool renew = known == views_.end() || alive_[known->second.get()].trees != tree;
  view_ = ViewOf(key, tree->forest(), tree_, tree->models(), now, renew);
  if (renew && view_) alive_[view_] = {tree, nullptr};
}

TreeView* Workspace::ViewOf(const std::string& key, const Forest& forest, int tree,
                            const NodeModels& models, double now, bool renew) {
  std::unique_ptr<TreeView>& view = views_[key];
  const bool is_first = !view;
  if (is_first) {
    view = std::make_unique<TreeView>();
    renew = true;
  }
  if (renew) {
    auto scene = std::make_shared<Scene>(BuildScene(forest, tree, models));
    if (run_ >= 0) NumberNodes(*run()->tree()->description(), *scene);
    view->SetScene(std::move(scene), size_of_, now);
    const auto closed = closed_.find(key);
    if (is_first && closed != closed_.end()) view->CloseAtFirst(closed->second);
  }
  view->SetStyle(style_, now);
  return view->scene()->nodes.empty() ? nullptr : view.get();
}

void Workspace::ShowFileTree(std::size_t file, int tree, double now) {
  run_ = -1;
  file_ = static_cast<int>(file);
  tree_ = tree;
  view_ = nullptr;
  if (tree < 0) return;
  const OpenFile& open = files_[file];
  const std::string key = "file:" + open.path + ":" + open.forest->trees()[Index(tree)].id;
  const auto known = views_.find(key);
  const bool renew = known == views_.end() || alive_[known->second.get()].trees != open.forest;
  view_ = ViewOf(key, *open.forest, tree, *open.models, now, renew);
  if (renew && view_) alive_[view_] = {open.forest, open.models};
}

void Workspace::ShowRun(std::size_t run) {
  if (run >= runs_.size()) return;
  run_ = static_cast<int>(run);
  file_ = -1;
  view_ = nullptr;  // until the next Update
  tree_ = -1;
}

void Workspace::ShowNextRun() {
  if (runs_.empty()) return;
  ShowRun(Index(run_ + 1) % runs_.size());
}

const Forest* Workspace::forest() const {
  if (run()) return run()->tree() ? &run()->tree()->forest() : nullptr;
  return file_ >= 0 ? files_[Index(file_)].forest.get() : nullptr;
}

void Workspace::MeasureAgain(double now) {
  for (auto& [key, view] : views_) view->MeasureAgain(size_of_, now);
}

void Workspace::SetStyle(const LayoutStyle& style, double now) {
  style_ = style;
  for (auto& [key, view] : views_) view->SetStyle(style, now);
}

}  // namespace coppice::editor
