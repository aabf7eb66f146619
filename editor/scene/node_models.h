// What is known of the node types: category, description and ports by ID.
//
// The built-in types are known from the engine. The others come from a <TreeNodesModel>, which
// stands in a project's file, in a file of its own, or in what a running robot sends.
#ifndef COPPICE_EDITOR_SCENE_NODE_MODELS_H_
#define COPPICE_EDITOR_SCENE_NODE_MODELS_H_

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/data/port.h"
#include "bt_core/model/document.h"
#include "bt_core/model/manifest.h"

namespace coppice::editor {

struct PortModel {
  std::string name;
  PortDirection direction = PortDirection::kInput;
  std::string type;  ///< may be empty
  std::string description;
  std::optional<std::string> default_text;
};

struct NodeModel {
  std::string id;
  NodeCategory category = NodeCategory::kAction;
  std::string description;
  std::vector<PortModel> ports;  ///< in the declared order
  std::string source;            ///< "built-in", or "file:line" of the model

  const PortModel* FindPort(std::string_view name) const;
};

class NodeModels {
 public:
  /// Knows the built-in types.
  NodeModels();

  /// Adds the models of every <TreeNodesModel> in the document; a type that is known already is
  /// replaced, but for the built-in ones.
  void AddFrom(const Document& document);

  /// The model of that ID, or null.
  const NodeModel* Find(std::string_view id) const;

  const std::map<std::string, NodeModel, std::less<>>& all() const { return models_; }

 private:
  std::map<std::string, NodeModel, std::less<>> models_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SCENE_NODE_MODELS_H_
