#include "bt_core/engine/compile/model_registry.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "bt_core/engine/compile/compiler_children.h"
#include "bt_core/engine/compile/type_names.h"

namespace coppice {
namespace {

// A type of which only the name is known. Its values are the texts that stand for them.
struct NamedType {
  explicit NamedType(std::string given) : name(std::move(given)), type(TypeOf<std::string>()) {
    type.name = name.c_str();
    type.kind = TypeKind::kOther;
  }
  std::string name;
  Type type;
};

using NamedTypes = std::map<std::string, std::unique_ptr<NamedType>>;

const Type* TypeOf(const PortModel& port, const Registry& registry, NamedTypes& named) {
  if (port.type.empty() || port.type == "BT::AnyTypeAllowed") return nullptr;
  if (const Type* known = FindType(registry, port.type)) return known;
  std::unique_ptr<NamedType>& type = named[port.type];
  if (!type) type = std::make_unique<NamedType>(port.type);
  return &type->type;
}

Manifest ManifestOf(const NodeModel& model, const Registry& registry, NamedTypes& named) {
  Manifest manifest{model.id, model.category, model.description, {}};
  for (const PortModel& port : model.ports) {
    manifest.ports.push_back({port.name, port.direction, TypeOf(port, registry, named),
                              port.description, false, port.default_text});
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
