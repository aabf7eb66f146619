// The classes of the built-in nodes, by ID.
#ifndef COPPICE_BT_CORE_COMPAT_BUILT_INS_H_
#define COPPICE_BT_CORE_COMPAT_BUILT_INS_H_

#include <memory>
#include <string>

#include "behaviortree_cpp/bt_factory.h"
#include "bt_core/engine/registry.h"

namespace BT::internal {

/// The object that stands for a built-in node in a tree.
std::unique_ptr<TreeNode> MakeBuiltIn(const coppice::Registry::Entry& entry,
                                      const std::string& name, const NodeConfig& config);

/// What users see of a built-in type.
TreeNodeManifest ManifestOf(const coppice::Manifest& manifest);

/// How the engine reads the text of a type.
TypeInfo InfoOf(const coppice::Type* type);

}  // namespace BT::internal

#endif  // COPPICE_BT_CORE_COMPAT_BUILT_INS_H_
