// Types by the names that <TreeNodesModel> uses: our own names, those of the types that the ports
// of a registry have, and what BehaviorTree.CPP writes ("std::string").
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_TYPE_NAMES_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_TYPE_NAMES_H_

#include <string>
#include <string_view>

#include "bt_core/engine/registry.h"

namespace coppice {

/// The name as a person writes it, without allocators and the like: BehaviorTree.CPP writes what
/// the C++ compiler calls a type.
std::string PlainTypeName(std::string_view name);

/// A type of which only the name is known. Its values are the texts that stand for them.
struct NamedType {
  explicit NamedType(std::string given);
  NamedType(const NamedType&) = delete;
  NamedType& operator=(const NamedType&) = delete;

  std::string name;
  Type type;
};

bool HasOnlyAName(const Type& type);

/// Null for a type that is not known and for BT::AnyTypeAllowed.
const Type* FindType(const Registry& registry, std::string_view name);

/// What a model writes for the type of a port; "BT::AnyTypeAllowed" for a port of any type.
const char* TypeName(const PortDeclaration& port);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_TYPE_NAMES_H_
