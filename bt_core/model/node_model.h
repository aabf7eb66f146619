// Node types as a file describes them, in <TreeNodesModel>: what the engine itself knows from C++
// is in Manifest. SubTree models say which ports a tree has; models of leaves tell a checker or an
// editor about leaves that are not compiled into it.
//
//   <TreeNodesModel>
//     <SubTree ID="Dock"><input_port name="station" type="Pose2D"/></SubTree>
//     <Action ID="Say"><input_port name="text" default="hello">what to say</input_port></Action>
//   </TreeNodesModel>
#ifndef COPPICE_BT_CORE_MODEL_NODE_MODEL_H_
#define COPPICE_BT_CORE_MODEL_NODE_MODEL_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt_core/data/port.h"
#include "bt_core/model/document.h"
#include "bt_core/model/manifest.h"

namespace coppice {

struct PortModel {
  std::string name;
  PortDirection direction = PortDirection::kInput;
  std::string type;  ///< the name of the type as written; empty if the model does not say
  std::string description;
  std::optional<std::string> default_text;  ///< a literal, or a key in braces
};

struct NodeModel {
  std::string id;
  NodeCategory category = NodeCategory::kAction;
  std::string description;
  std::vector<PortModel> ports;                               ///< in the written order
  std::vector<std::pair<std::string, std::string>> metadata;  ///< of <MetadataFields>
  std::uint32_t document = 0;                                 ///< where it stands: document number
  ElementIndex element{0};                                    ///< and element

  /// The port of that name, or null.
  const PortModel* FindPort(std::string_view name) const;
};

/// True if the two have the same category and the same ports with the same directions, types and
/// defaults. Descriptions and metadata do not count.
bool HasSameInterface(const NodeModel& a, const NodeModel& b);

/// The models below the <TreeNodesModel> element. `number` becomes NodeModel::document. What is no
/// model is left out with a warning.
std::vector<NodeModel> ReadModels(const Document& document, const Element& tree_nodes_model,
                                  std::uint32_t number, Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_NODE_MODEL_H_
