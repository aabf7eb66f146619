// What a tree shares with those who use it as a SubTree: the ports that its model declares, and the
// keys that its nodes use although the tree does not own them.
//
//   for (const InterfacePort& port : InterfaceOf(files, models, "Dock")) { /* port.model.name */ }
#ifndef COPPICE_EDITOR_DOCUMENT_TREE_INTERFACE_H_
#define COPPICE_EDITOR_DOCUMENT_TREE_INTERFACE_H_

#include <string_view>
#include <vector>

#include "bt_core/model/node_model.h"
#include "editor/document/project_names.h"

namespace coppice::editor {

struct InterfacePort {
  PortModel model;  ///< of one that is not declared: type and direction as its users have them
  bool declared = false;
};

/// The declared ports in the declared order, then the others in the order of their first use. A key
/// belongs to the tree if its nodes both write and read it, unless somebody who uses the tree names
/// it. Empty if there is no such tree.
std::vector<InterfacePort> InterfaceOf(const ProjectFiles& files, const NodeModels& models,
                                       std::string_view tree);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_TREE_INTERFACE_H_
