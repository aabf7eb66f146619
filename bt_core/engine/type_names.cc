#include "bt_core/engine/type_names.h"

#include <cstdint>
#include <string>
#include <utility>

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
      {"double", &TypeOf<double>()},
      {"string", &TypeOf<std::string>()},
      {"std::string", &TypeOf<std::string>()},
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
