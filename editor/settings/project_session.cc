#include "editor/settings/project_session.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "editor/files/linked_project.h"
#include "editor/workspace/canvas_tabs.h"

namespace coppice::editor {
namespace {

// As it is open now, or else as it is found below the folder.
std::string PathOf(const EditorState& state, const std::string& folder, const std::string& name) {
  for (const OpenFile& file : state.workspace.files()) {
    if (PathInProject(folder, file.path) == name) return file.path;
  }
  return folder + "/" + name;
}

// Tiles that come and go with what the user does stay as they are.
void ShowTiles(const Tiles& kept, Tiles& tiles) {
  const Tiles before = tiles;
  tiles = kept;
  tiles.tests = before.tests;
  tiles.others = before.others;
}

}  // namespace

void ProjectSession::Follow(EditorState& state) {
  const OpenFile* const file = state.workspace.file();
  if (!is_on_ || !file || file->path == path_) return;
  const EditedFile* const edited = state.workspace.project().Find(file->path);
  if (edited && edited->is_new) return;
  path_ = file->path;
  std::string project = ProjectFolder(path_);
  if (project == project_) return;
  Keep(state);
  if (!project_.empty()) seen_[project_] = SettingsOf(state);
  project_ = std::move(project);
  kept_.clear();
  rest_ = {};
  if (const auto seen = seen_.find(project_); seen != seen_.end()) {
    ShowTiles(seen->second.tiles, state.screen.tiles);
    state.workspace.SetStyle(seen->second.style, state.now);
    return;
  }
  Diagnostics problems;
  const std::optional<ProjectSettings> kept = store_.Load(project_, problems);
  if (kept) Begin(state, *kept);
  if (!problems.has_errors()) return;
  state.Notify("the settings of this project are damaged: " + ToString(problems.all().front()),
               state.now, true);
}

void ProjectSession::Begin(EditorState& state, const ProjectSettings& settings) {
  kept_ = WriteProject(settings);
  rest_ = settings;
  ShowTiles(settings.tiles, state.screen.tiles);
  for (const ProjectTree& tree : settings.trees) {
    state.workspace.CloseAtFirst(PathOf(state, project_, tree.file), tree.tree, tree.closed);
  }
  state.workspace.SetStyle(settings.style, state.now);
}

bool ProjectSession::OpenRest(EditorState& state) {
  if (rest_.folder.empty()) return false;
  const ProjectSettings rest = std::exchange(rest_, {});
  for (const std::string& name : rest.files) {
    const std::string path = PathOf(state, rest.folder, name);
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error)) state.workspace.OpenBehind(path, state.now);
  }
  std::vector<CanvasTab> tabs;
  for (const ProjectTree& tree : rest.trees) {
    if (tree.has_tab) tabs.push_back({PathOf(state, rest.folder, tree.file), tree.tree});
  }
  for (CanvasTab& tab : state.canvas.tabs) {
    if (std::find(tabs.begin(), tabs.end(), tab) == tabs.end()) tabs.push_back(std::move(tab));
  }
  state.canvas.tabs = std::move(tabs);
  UpdateTabs(state);
  return true;
}

ProjectSettings ProjectSession::SettingsOf(const EditorState& state) const {
  ProjectSettings settings;
  settings.folder = project_;
  settings.style = state.workspace.style();
  settings.tiles = state.screen.tiles;
  for (const OpenFile& file : state.workspace.files()) {
    const EditedFile* const edited = state.workspace.project().Find(file.path);
    const std::string name = PathInProject(project_, file.path);
    const bool is_new = edited && edited->is_new;
    if (!name.empty() && !is_new) settings.files.push_back(name);
  }
  const auto is_open = [&](const std::string& name) {
    return std::find(settings.files.begin(), settings.files.end(), name) != settings.files.end();
  };
  for (const CanvasTab& tab : state.canvas.tabs) {
    const std::string name = PathInProject(project_, tab.path);
    if (is_open(name)) settings.trees.push_back({name, tab.tree, true, {}});
  }
  for (ClosedNodes& closed : state.workspace.closed()) {
    const std::string name = PathInProject(project_, closed.path);
    if (!is_open(name)) continue;
    const auto same = std::find_if(
        settings.trees.begin(), settings.trees.end(),
        [&](const ProjectTree& tree) { return tree.file == name && tree.tree == closed.tree; });
    if (same != settings.trees.end()) {
      same->closed = std::move(closed.nodes);
    } else {
      settings.trees.push_back({name, closed.tree, false, std::move(closed.nodes)});
    }
  }
  return settings;
}

void ProjectSession::Keep(const EditorState& state) {
  // What is not open again yet would be forgotten.
  if (!is_on_ || project_.empty() || !rest_.folder.empty()) return;
  const ProjectSettings settings = SettingsOf(state);
  std::string text = WriteProject(settings);
  if (text != kept_ && store_.Keep(settings)) kept_ = std::move(text);
}

}  // namespace coppice::editor
