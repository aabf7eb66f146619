#include "bt_core/engine/model_registry.h"

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "bt_core/engine/compiler_children.h"
#include "bt_core/engine/type_names.h"

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

}  // namespace

void AddModels(const Project& models, Registry& registry) {
  const auto named = std::make_shared<NamedTypes>();
  for (const auto& [id, model] : models.models()) {
    if (registry.Find(id)) continue;
    registry.AddManifest(ManifestOf(model, registry, *named), ChildrenOf(model.category), named);
  }
}

}  // namespace coppice
