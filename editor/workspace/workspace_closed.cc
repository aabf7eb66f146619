// The part of the workspace that knows which nodes of trees are closed, also of those that are not
// shown yet.
#include <utility>

#include "editor/workspace/workspace.h"

namespace coppice::editor {
namespace {

std::string KeyOf(const std::string& path, const std::string& tree) {
  return "file:" + path + ":" + tree;
}

}  // namespace

void Workspace::CloseAtFirst(const std::string& path, const std::string& tree,
                             std::vector<std::string> nodes) {
  const std::string key = KeyOf(path, tree);
  if (const auto view = views_.find(key); view != views_.end() && view->second->needs_fit) {
    view->second->CloseAtFirst(nodes);
  }
  closed_[key] = std::move(nodes);
}

std::vector<ClosedNodes> Workspace::closed() const {
  std::vector<ClosedNodes> all;
  for (const OpenFile& file : files_) {
    for (const TreeEntry& tree : file.forest->trees()) {
      const std::string key = KeyOf(file.path, tree.id);
      const auto view = views_.find(key);
      const auto waiting = closed_.find(key);
      std::vector<std::string> nodes;
      if (view != views_.end()) {
        nodes = view->second->ClosedNodes();
      } else if (waiting != closed_.end()) {
        nodes = waiting->second;
      }
      if (!nodes.empty()) all.push_back({file.path, tree.id, std::move(nodes)});
    }
  }
  return all;
}

}  // namespace coppice::editor
