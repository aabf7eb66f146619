// The three parts of the list of built-in nodes, and the words that they are written in.
#ifndef COPPICE_BT_CORE_NODES_BUILT_IN_TABLES_H_
#define COPPICE_BT_CORE_NODES_BUILT_IN_TABLES_H_

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/nodes/node_type.h"

namespace coppice {

std::vector<BuiltIn> BuiltInControls();
std::vector<BuiltIn> BuiltInDecorators();
std::vector<BuiltIn> BuiltInLeaves();

namespace tables {

inline constexpr ChildCount kNone{0, 0};
inline constexpr ChildCount kOne{1, 1};
inline constexpr ChildCount kSome{1, UINT32_MAX};

/// An input; required if it has no default.
template <class T>
PortDeclaration In(std::string name, std::string description,
                   std::optional<std::string> default_text = std::nullopt) {
  const bool required = !default_text.has_value();
  return {std::move(name), PortDirection::kInput,  &TypeOf<T>(), std::move(description),
          required,        std::move(default_text)};
}

/// An input without default that may be left out.
template <class T>
PortDeclaration MayIn(std::string name, std::string description) {
  PortDeclaration port = In<T>(std::move(name), std::move(description));
  port.required = false;
  return port;
}

/// An output, which may be left out.
template <class T>
PortDeclaration Out(std::string name, std::string description) {
  return {std::move(name), PortDirection::kOutput, &TypeOf<T>(), std::move(description), false,
          std::nullopt};
}

/// A port of any type.
inline PortDeclaration Any(PortDirection direction, std::string name, std::string description) {
  return {std::move(name), direction, nullptr, std::move(description), true, std::nullopt};
}

/// A private slot.
template <class T>
PortDeclaration Own(std::string description) {
  return {"", PortDirection::kMailbox, &TypeOf<T>(), std::move(description), false, std::nullopt};
}

inline BuiltIn Node(NodeType type, NodeCategory category, ChildCount children, std::string id,
                    std::string description, std::vector<PortDeclaration> ports) {
  return {type, children, {std::move(id), category, std::move(description), std::move(ports)}};
}

}  // namespace tables
}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_BUILT_IN_TABLES_H_
