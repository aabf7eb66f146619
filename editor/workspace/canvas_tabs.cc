#include "editor/workspace/canvas_tabs.h"

#include <algorithm>

namespace coppice::editor {
namespace {

struct FileTree {
  std::size_t file = 0;
  int tree = -1;
};

FileTree Find(const Workspace& workspace, const CanvasTab& tab) {
  const auto& files = workspace.files();
  for (std::size_t f = 0; f < files.size(); ++f) {
    if (files[f].path == tab.path) return {f, files[f].forest->Find(tab.tree)};
  }
  return {};
}

CanvasTab ShownTree(const EditorState& state) {
  const OpenFile* file = state.workspace.file();
  return file ? CanvasTab{file->path, state.workspace.ShownTreeId()} : CanvasTab{};
}

}  // namespace

void UpdateTabs(EditorState& state) {
  std::vector<CanvasTab>& tabs = state.canvas.tabs;
  tabs.erase(
      std::remove_if(tabs.begin(), tabs.end(),
                     [&](const CanvasTab& tab) { return Find(state.workspace, tab).tree < 0; }),
      tabs.end());
  const CanvasTab shown = ShownTree(state);
  if (!shown.tree.empty() && ShownTab(state) == tabs.size()) tabs.push_back(shown);
}

std::size_t ShownTab(const EditorState& state) {
  const std::vector<CanvasTab>& tabs = state.canvas.tabs;
  return static_cast<std::size_t>(std::find(tabs.begin(), tabs.end(), ShownTree(state)) -
                                  tabs.begin());
}

void ShowTab(EditorState& state, std::size_t tab, double now) {
  if (tab >= state.canvas.tabs.size()) return;
  const FileTree found = Find(state.workspace, state.canvas.tabs[tab]);
  if (found.tree >= 0) state.workspace.ShowFileTree(found.file, found.tree, now);
}

void CloseTab(EditorState& state, std::size_t tab, double now) {
  std::vector<CanvasTab>& tabs = state.canvas.tabs;
  if (tab >= tabs.size() || tabs.size() < 2) return;
  const bool shown = tab == ShownTab(state);
  tabs.erase(tabs.begin() + static_cast<std::ptrdiff_t>(tab));
  if (shown) ShowTab(state, std::min(tab, tabs.size() - 1), now);
}

}  // namespace coppice::editor
