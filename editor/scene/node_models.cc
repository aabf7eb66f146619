#include "editor/scene/node_models.h"

#include <utility>

#include "bt_core/nodes/node_type.h"

namespace coppice::editor {
namespace {

constexpr char kBuiltIn[] = "built-in";

NodeModel FromManifest(const Manifest& manifest) {
  NodeModel model;
  model.id = manifest.id;
  model.category = manifest.category;
  model.description = manifest.description;
  model.source = kBuiltIn;
  for (const PortDeclaration& port : manifest.ports) {
    if (port.direction == PortDirection::kMailbox) continue;
    model.ports.push_back({port.name, port.direction, port.type ? port.type->name : "",
                           port.description, port.default_text});
  }
  return model;
}

std::optional<PortDirection> DirectionFromTag(std::string_view tag) {
  if (tag == "input_port") return PortDirection::kInput;
  if (tag == "output_port") return PortDirection::kOutput;
  if (tag == "inout_port") return PortDirection::kInOut;
  return std::nullopt;
}

// The text between the start tag and the next tag, with the usual entities resolved.
std::string TextOf(const Document& document, const Element& element) {
  const std::string& text = document.text();
  const std::size_t open = text.find('>', element.offset);
  if (open == std::string::npos || text[open - 1] == '/') return {};
  const std::size_t close = text.find('<', open);
  std::string raw = text.substr(open + 1, close - open - 1);
  constexpr std::pair<const char*, char> kEntities[] = {
      {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}};
  for (const auto& [entity, character] : kEntities) {
    for (std::size_t at = raw.find(entity); at != std::string::npos;
         at = raw.find(entity, at + 1)) {
      raw.replace(at, std::string_view(entity).size(), 1, character);
    }
  }
  return raw;
}

PortModel ReadPort(const Document& document, const Element& element, PortDirection direction) {
  PortModel port;
  port.name = document.AttributeValue(element, "name");
  port.direction = direction;
  port.type = document.AttributeValue(element, "type");
  port.description = TextOf(document, element);
  if (const Attribute* text = document.FindAttribute(element, "default")) {
    port.default_text = std::string(text->value);
  }
  return port;
}

// <MetadataFields><Metadata description="..."/></MetadataFields>
std::string ReadDescription(const Document& document, const Element& fields) {
  for (ElementIndex i = fields.first_child; i != kNoElement; i = document.element(i).next_sibling) {
    const std::string_view text = document.AttributeValue(document.element(i), "description");
    if (!text.empty()) return std::string(text);
  }
  return {};
}

NodeModel ReadModel(const Document& document, const Element& element, NodeCategory category) {
  NodeModel model;
  model.id = document.AttributeValue(element, "ID");
  model.category = category;
  const SourceLocation where = document.Location(element.offset);
  model.source = where.file + ":" + std::to_string(where.line);
  for (ElementIndex i = element.first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    const Element& child = document.element(i);
    if (const auto direction = DirectionFromTag(child.tag)) {
      model.ports.push_back(ReadPort(document, child, *direction));
    } else if (child.tag == "MetadataFields") {
      model.description = ReadDescription(document, child);
    } else if (child.tag == "description") {
      model.description = TextOf(document, child);
    }
  }
  return model;
}

}  // namespace

const PortModel* NodeModel::FindPort(std::string_view name) const {
  for (const PortModel& port : ports) {
    if (port.name == name) return &port;
  }
  return nullptr;
}

NodeModels::NodeModels() {
  for (const BuiltIn& built_in : BuiltIns()) {
    models_[built_in.manifest.id] = FromManifest(built_in.manifest);
  }
}

void NodeModels::AddFrom(const Document& document) {
  if (document.elements().empty()) return;
  for (const Element& element : document.elements()) {
    const bool inside =
        element.parent != kNoElement && document.element(element.parent).tag == "TreeNodesModel";
    if (!inside) continue;
    const std::optional<NodeCategory> category = CategoryFromTag(element.tag);
    if (!category) continue;
    NodeModel model = ReadModel(document, element, *category);
    const NodeModel* known = Find(model.id);
    if (model.id.empty() || (known && known->source == kBuiltIn)) continue;
    models_[model.id] = std::move(model);
  }
}

const NodeModel* NodeModels::Find(std::string_view id) const {
  const auto found = models_.find(id);
  return found == models_.end() ? nullptr : &found->second;
}

}  // namespace coppice::editor
