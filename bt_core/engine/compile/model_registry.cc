#include "bt_core/engine/compile/model_registry.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "bt_core/engine/compile/compiler_children.h"
#include "bt_core/engine/compile/type_names.h"

namespace coppice {
namespace {

using NamedTypes = std::map<std::string, std::unique_ptr<NamedType>>;

const Type* TypeOf(const PortModel& port, const Registry& registry, NamedTypes& named) {
  if (port.type.empty() || port.type == "BT::AnyTypeAllowed") return nullptr;
  if (const Type* known = FindType(registry, port.type)) return known;
  const std::string name = PlainTypeName(port.type);
  std::unique_ptr<NamedType>& type = named[name];
  if (!type) type = std::make_unique<NamedType>(name);
  return &type->type;
}

// The peer's generator writes defaults as C++ does: 1u, 0.5f.
std::optional<std::string> DefaultOf(const PortModel& port, const Type* type) {
  if (!port.default_text || !type || type->kind >= TypeKind::kString) return port.default_text;
  const std::size_t end = port.default_text->find_last_not_of("uUlLfF");
  const std::string number = port.default_text->substr(0, end + 1);
  Value value;
  const bool needs_it = !value.Parse(*type, *port.default_text) && value.Parse(*type, number);
  return needs_it ? number : port.default_text;
}

Manifest ManifestOf(const NodeModel& model, const Registry& registry, NamedTypes& named) {
  Manifest manifest{model.id, model.category, model.description, {}};
  for (const PortModel& port : model.ports) {
    const Type* const type = TypeOf(port, registry, named);
    manifest.ports.push_back(
        {port.name, port.direction, type, port.description, false, DefaultOf(port, type)});
  }
  return manifest;
}

// How the two differ; empty if they may be the same.
std::string Contradiction(const NodeModel& model, const Manifest& built_in) {
  const std::string other =
      ", but the built-in " + std::string(ToString(built_in.category)) + " of that name ";
  if (model.category != built_in.category) {
    return "is of category " + std::string(ToString(model.category)) + other + "is not";
  }
  for (const PortModel& port : model.ports) {
    const auto has_name = [&port](const PortDeclaration& p) { return p.name == port.name; };
    if (std::any_of(built_in.ports.begin(), built_in.ports.end(), has_name)) continue;
    return "has port \"" + port.name + "\"" + other + "has not";
  }
  for (const PortDeclaration& port : built_in.ports) {
    if (!port.required || port.default_text || model.FindPort(port.name)) continue;
    return "has no port \"" + port.name + "\"" + other + "needs it";
  }
  return {};
}

}  // namespace

void RemoveContradicted(const Project& models, Registry& registry, Diagnostics& diagnostics) {
  for (const auto& [id, model] : models.models()) {
    if (!registry.HasBuiltIn(id)) continue;
    const std::string why = Contradiction(model, registry.Find(id)->manifest);
    if (why.empty()) continue;
    const Document& document = models.documents()[model.document];
    diagnostics.Warning(document.Location(document.element(model.element).offset),
                        "\"" + id + "\" of this model " + why,
                        "trees are checked against the model");
    registry.Remove(id);
  }
}

void AddModels(const Project& models, Registry& registry) {
  std::vector<const NodeModel*> all;
  for (const auto& [id, model] : models.models()) all.push_back(&model);
  AddModels(all, registry);
}

void AddModels(const std::vector<const NodeModel*>& models, Registry& registry) {
  const auto named = std::make_shared<NamedTypes>();
  for (const NodeModel* model : models) {
    if (registry.Find(model->id)) continue;
    registry.AddManifest(ManifestOf(*model, registry, *named), ChildrenOf(model->category), named);
  }
}

}  // namespace coppice
