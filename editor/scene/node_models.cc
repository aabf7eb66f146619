#include "editor/scene/node_models.h"

#include <utility>

#include "bt_core/engine/compile/shipped_models.h"
#include "bt_core/nodes/node_type.h"

namespace coppice::editor {
namespace {

KnownModel FromManifest(const Manifest& manifest) {
  KnownModel model;
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

}  // namespace

NodeModels::NodeModels() {
  for (const BuiltIn& built_in : BuiltIns()) {
    models_[built_in.manifest.id] = FromManifest(built_in.manifest);
  }
}

void NodeModels::AddFrom(const Document& document) { Add(document, nullptr); }

void NodeModels::AddTold(const Document& document, const std::string& teller) {
  Add(document, &teller);
}

void NodeModels::Add(const Document& document, const std::string* teller) {
  Diagnostics ignored;
  for (const Element& element : document.elements()) {
    if (element.tag != "TreeNodesModel") continue;
    for (NodeModel& model : ReadModels(document, element, 0, ignored)) {
      const KnownModel* known = Find(model.id);
      if (known && known->source == kBuiltIn) continue;
      const SourceLocation where = document.Location(document.element(model.element).offset);
      std::string id = model.id;
      models_[std::move(id)] = {std::move(model),
                                teller ? *teller : where.file + ":" + std::to_string(where.line)};
    }
  }
}

const KnownModel* NodeModels::Find(std::string_view id) const {
  const auto found = models_.find(id);
  return found == models_.end() ? nullptr : &found->second;
}

std::string_view TypeText(std::string_view type) {
  return type == "BT::AnyTypeAllowed" || type == "AnyTypeAllowed" ? "any type" : type;
}

NodeModels ModelsFor(const std::vector<const Document*>& given,
                     const std::vector<const Document*>& trees) {
  const auto add_own = [&](NodeModels& models) {
    for (const Document* document : given) models.AddFrom(*document);
    for (const Document* document : trees) models.AddFrom(*document);
  };
  NodeModels own;
  add_own(own);
  const std::vector<ShippedTypes> shipped =
      FindShippedTypes(trees, [&own](std::string_view id) { return own.Find(id) != nullptr; });
  if (shipped.empty()) return own;
  NodeModels all;
  for (const ShippedTypes& found : shipped) all.AddFrom(found.set->models.documents().front());
  add_own(all);
  return all;
}

}  // namespace coppice::editor
