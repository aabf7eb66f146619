// What may stand where in a tree, as far as the node models tell: used to refuse a change with a
// reason before it is made. What is not known is allowed; the engine's checker has the last word.
#ifndef COPPICE_EDITOR_DOCUMENT_NODE_RULES_H_
#define COPPICE_EDITOR_DOCUMENT_NODE_RULES_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "bt_core/base/outcome.h"
#include "bt_core/model/document.h"
#include "bt_core/model/manifest.h"
#include "editor/scene/node_models.h"

namespace coppice::editor {

class NodeRules {
 public:
  /// `models` must outlive the rules.
  explicit NodeRules(const NodeModels& models) : models_(models) {}

  const NodeModels& models() const { return models_; }

  /// At most so many children; UINT32_MAX: no limit, or not known. A <BehaviorTree> has one.
  std::uint32_t MaxChildren(const Document& document, ElementIndex element) const;
  std::uint32_t MaxChildrenOf(std::string_view id) const;

  /// Whether `more` further children fit.
  Outcome HasRoom(const Document& document, ElementIndex parent, std::uint32_t more) const;

  /// Nothing if the type is unknown.
  std::optional<NodeCategory> CategoryOf(const Document& document, ElementIndex element) const;

 private:
  const NodeModels& models_;
};

/// The ID of its type: of <Action ID="Say"/> and <Say/> "Say"; of a SubTree that of its tree.
std::string_view TypeOf(const Document& document, ElementIndex element);

/// The name given in the XML, else its type.
std::string_view NameOf(const Document& document, ElementIndex element);

/// True for what lies below a <BehaviorTree>: the nodes.
bool IsNode(const Document& document, ElementIndex element);

/// The <BehaviorTree> that it is or lies in, or kNoElement.
ElementIndex TreeOf(const Document& document, ElementIndex element);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_NODE_RULES_H_
