#include "editor/workspace/interface_cache.h"

#include "editor/document/project_names.h"

namespace coppice::editor {

const std::vector<InterfacePort>& InterfaceCache::Of(const std::string& tree,
                                                     const Workspace& workspace,
                                                     const ProjectFiles& files) {
  return Find(tree, workspace, files).ports;
}

std::size_t InterfaceCache::UsesOf(const std::string& tree, const Workspace& workspace,
                                   const ProjectFiles& files) {
  return Find(tree, workspace, files).uses;
}

const InterfaceCache::Known& InterfaceCache::Find(const std::string& tree,
                                                  const Workspace& workspace,
                                                  const ProjectFiles& files) {
  static const Known kNothing;
  const OpenFile* const file = workspace.file();
  if (!file) return kNothing;
  if (models_ != file->models || version_ != workspace.project().version()) {
    models_ = file->models;
    version_ = workspace.project().version();
    trees_.clear();
  }
  const auto [known, is_new] = trees_.try_emplace(tree);
  if (is_new) {
    known->second = {InterfaceOf(files, *models_, tree), SubTreesOf(files, tree).size()};
  }
  return known->second;
}

}  // namespace coppice::editor
