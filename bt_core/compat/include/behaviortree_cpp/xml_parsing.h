// Trees and node types as XML.
#pragma once

#include <string>

#include "behaviortree_cpp/bt_factory.h"

namespace BT {

/// <TreeNodesModel> with the registered types.
std::string writeTreeNodesModelXML(const BehaviorTreeFactory& factory,
                                   bool include_builtin = false);
/// An XML schema of trees of these types, in the compact form.
std::string writeTreeXSD(const BehaviorTreeFactory& factory);
/// The trees as they were written. `add_metadata`: with _uid and _fullpath.
std::string WriteTreeToXML(const Tree& tree, bool add_metadata, bool add_builtin_models);

}  // namespace BT
