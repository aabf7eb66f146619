#include "editor/document/node_rules.h"

#include "bt_core/nodes/node_type.h"

namespace coppice::editor {
namespace {

constexpr std::uint32_t kNoLimit = UINT32_MAX;

const BuiltIn* FindBuiltIn(std::string_view id) {
  for (const BuiltIn& built_in : BuiltIns()) {
    if (built_in.manifest.id == id) return &built_in;
  }
  return nullptr;
}

std::uint32_t MaxChildrenOf(NodeCategory category) {
  switch (category) {
    case NodeCategory::kControl:
      return kNoLimit;
    case NodeCategory::kDecorator:
      return 1;
    case NodeCategory::kAction:
    case NodeCategory::kCondition:
    case NodeCategory::kSubTree:
      return 0;
  }
  return kNoLimit;
}

}  // namespace

std::uint32_t NodeRules::MaxChildrenOf(std::string_view id) const {
  if (id == "SubTree") return 0;
  if (const BuiltIn* built_in = FindBuiltIn(id)) return built_in->children.max;
  const NodeModel* model = models_.Find(id);
  return model ? editor::MaxChildrenOf(model->category) : kNoLimit;
}

std::uint32_t NodeRules::MaxChildren(const Document& document, ElementIndex index) const {
  const Element& element = document.element(index);
  if (element.tag == "BehaviorTree") return 1;
  if (element.tag == "SubTree" || element.tag == "SubTreePlus") return 0;
  const std::string_view type = TypeOf(document, index);
  if (type == element.tag || models_.Find(type)) return MaxChildrenOf(type);
  const auto category = CategoryFromTag(element.tag);
  return category ? editor::MaxChildrenOf(*category) : kNoLimit;
}

Outcome NodeRules::HasRoom(const Document& document, ElementIndex parent,
                           std::uint32_t more) const {
  const std::uint32_t limit = MaxChildren(document, parent);
  const std::uint32_t count = document.element(parent).child_count;
  if (limit == kNoLimit || count + more <= limit) return {};
  if (document.element(parent).tag == "BehaviorTree") {
    return Problem{count == 0 ? "a tree has one root node"
                              : "a tree has one root node, and this one has it"};
  }
  const std::string name(NameOf(document, parent));
  if (limit == 0) return Problem{name + " takes no children"};
  if (limit == 1) return Problem{name + " takes one child"};
  return Problem{name + " takes at most " + std::to_string(limit) + " children"};
}

std::optional<NodeCategory> NodeRules::CategoryOf(const Document& document,
                                                  ElementIndex index) const {
  const Element& element = document.element(index);
  if (element.tag == "SubTreePlus") return NodeCategory::kSubTree;
  if (const auto category = CategoryFromTag(element.tag)) return category;
  const NodeModel* model = models_.Find(TypeOf(document, index));
  return model ? std::optional(model->category) : std::nullopt;
}

std::string_view TypeOf(const Document& document, ElementIndex index) {
  const Element& element = document.element(index);
  if (CategoryFromTag(element.tag) || element.tag == "SubTreePlus") {
    const std::string_view id = document.AttributeValue(element, "ID");
    if (!id.empty()) return id;
  }
  return element.tag;
}

std::string_view NameOf(const Document& document, ElementIndex index) {
  const std::string_view name = document.AttributeValue(document.element(index), "name");
  return name.empty() ? TypeOf(document, index) : name;
}

bool IsNode(const Document& document, ElementIndex element) {
  const ElementIndex tree = TreeOf(document, element);
  return tree != kNoElement && tree != element;
}

ElementIndex TreeOf(const Document& document, ElementIndex element) {
  while (element != kNoElement && document.element(element).tag != "BehaviorTree") {
    element = document.element(element).parent;
  }
  return element;
}

}  // namespace coppice::editor
