// The interfaces of trees as they are now, worked out once for each version of the project.
#ifndef COPPICE_EDITOR_WORKSPACE_INTERFACE_CACHE_H_
#define COPPICE_EDITOR_WORKSPACE_INTERFACE_CACHE_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "editor/document/tree_interface.h"
#include "editor/workspace/workspace.h"

namespace coppice::editor {

class InterfaceCache {
 public:
  /// Of the tree of that ID in the shown file; empty while a run is shown. Good till the next call.
  const std::vector<InterfacePort>& Of(const std::string& tree, const Workspace& workspace,
                                       const ProjectFiles& files);

  /// How many SubTrees run it.
  std::size_t UsesOf(const std::string& tree, const Workspace& workspace,
                     const ProjectFiles& files);

 private:
  struct Known {
    std::vector<InterfacePort> ports;
    std::size_t uses = 0;
  };

  const Known& Find(const std::string& tree, const Workspace& workspace, const ProjectFiles& files);

  std::uint64_t version_ = 0;
  std::shared_ptr<const NodeModels> models_;
  std::map<std::string, Known> trees_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_INTERFACE_CACHE_H_
