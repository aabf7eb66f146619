#include "editor/workspace/interface_cache.h"

namespace coppice::editor {

const std::vector<InterfacePort>& InterfaceCache::Of(const std::string& tree,
                                                     const Workspace& workspace,
                                                     const ProjectFiles& files) {
  static const std::vector<InterfacePort> kNone;
  const OpenFile* const file = workspace.file();
  if (!file) return kNone;
  if (models_ != file->models || version_ != workspace.project().version()) {
    models_ = file->models;
    version_ = workspace.project().version();
    interfaces_.clear();
  }
  const auto [known, is_new] = interfaces_.try_emplace(tree);
  if (is_new) known->second = InterfaceOf(files, *models_, tree);
  return known->second;
}

}  // namespace coppice::editor
