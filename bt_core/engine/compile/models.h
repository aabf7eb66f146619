// The node types of a Registry as text: for the editor and the live view as <TreeNodesModel>, for
// people as a list.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_MODELS_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_MODELS_H_

#include <string>
#include <string_view>

#include "bt_core/engine/registry.h"

namespace coppice {

/// A whole XML document: <root> with one <TreeNodesModel> that holds every node type.
std::string WriteModels(const Registry& registry);

/// Only the <TreeNodesModel> element, indented by two spaces.
std::string WriteModelsElement(const Registry& registry);

/// One paragraph per node type: ID, category, description, ports with type, default and
/// description.
std::string DescribeNodes(const Registry& registry);

/// The text as it must stand inside a double-quoted attribute.
std::string EscapeXml(std::string_view text);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_MODELS_H_
