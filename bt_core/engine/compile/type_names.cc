#include "bt_core/engine/compile/type_names.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/data/standard_types.h"

namespace coppice {
namespace {

const Type* FindBasicType(std::string_view name) {
  static const std::pair<std::string_view, const Type*> names[] = {
      {"bool", &TypeOf<bool>()},
      {"int", &TypeOf<int>()},
      {"unsigned", &TypeOf<unsigned>()},
      {"unsigned int", &TypeOf<unsigned>()},
      {"int64", &TypeOf<std::int64_t>()},
      {"int64_t", &TypeOf<std::int64_t>()},
      {"uint64", &TypeOf<std::uint64_t>()},
      {"uint64_t", &TypeOf<std::uint64_t>()},
      {"float", &TypeOf<float>()},
      {"double", &TypeOf<double>()},
      {"string", &TypeOf<std::string>()},
      {"std::string", &TypeOf<std::string>()},
      {"std::vector<int>", &TypeOf<std::vector<int>>()},
      {"std::vector<double>", &TypeOf<std::vector<double>>()},
      {"std::vector<bool>", &TypeOf<std::vector<bool>>()},
      {"std::vector<std::string>", &TypeOf<std::vector<std::string>>()},
      {"Status", &TypeOf<Status>()},
      {"BT::NodeStatus", &TypeOf<Status>()},
  };
  for (const auto& [known, type] : names) {
    if (known == name) return type;
  }
  return nullptr;
}

}  // namespace

const Type* FindType(const Registry& registry, std::string_view name) {
  if (name.empty()) return nullptr;
  if (const Type* basic = FindBasicType(name)) return basic;
  for (const auto& [id, entry] : registry.entries()) {
    for (const PortDeclaration& port : entry.manifest.ports) {
      if (port.type && port.type->name == name && port.type != &TypeOf<ScriptCode>()) {
        return port.type;
      }
    }
  }
  return nullptr;
}

const char* TypeName(const PortDeclaration& port) {
  return port.type ? port.type->name : "BT::AnyTypeAllowed";
}

}  // namespace coppice
