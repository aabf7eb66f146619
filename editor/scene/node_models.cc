#include "editor/scene/node_models.h"

#include <utility>

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

void NodeModels::AddFrom(const Document& document) {
  Diagnostics ignored;
  for (const Element& element : document.elements()) {
    if (element.tag != "TreeNodesModel") continue;
    for (NodeModel& model : ReadModels(document, element, 0, ignored)) {
      const KnownModel* known = Find(model.id);
      if (known && known->source == kBuiltIn) continue;
      const SourceLocation where = document.Location(document.element(model.element).offset);
      std::string id = model.id;
      models_[std::move(id)] = {std::move(model), where.file + ":" + std::to_string(where.line)};
    }
  }
}

const KnownModel* NodeModels::Find(std::string_view id) const {
  const auto found = models_.find(id);
  return found == models_.end() ? nullptr : &found->second;
}

}  // namespace coppice::editor
