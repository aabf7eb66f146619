// The classes of the built-in nodes: what dynamic_cast finds in a tree. The engine ticks the nodes
// themselves as data; a class only says which one it is, and cannot be derived from.
#pragma once

#include <string>
#include <type_traits>

#include "behaviortree_cpp/action_node.h"
#include "behaviortree_cpp/condition_node.h"
#include "behaviortree_cpp/control_node.h"
#include "behaviortree_cpp/decorator_node.h"

namespace BT::internal {

template <class Base>
class BuiltIn : public Base {
 public:
  explicit BuiltIn(const std::string& name, const NodeConfig& config = {}) : Base(name, config) {}

 protected:
  NodeStatus tick() override { return Base::TickThroughEngine(); }
};

/// Of leaves, which have a halt() of their own.
class BuiltInAction : public BuiltIn<ActionNodeBase> {
 public:
  using BuiltIn::BuiltIn;
  void halt() override { resetStatus(); }
};

template <class T, class = void>
struct IsBuiltIn : std::false_type {};
template <class T>
struct IsBuiltIn<T, std::void_t<typename T::BuiltInClass>> : std::true_type {};

}  // namespace BT::internal

/// Class NAME for the built-in node of that ID.
#define COPPICE_COMPAT_BUILT_IN(NAME, BASE, ID)                                                   \
  class NAME : public BASE {                                                                      \
   public:                                                                                        \
    using BuiltInClass = NAME;                                                                    \
    static constexpr const char* kBuiltInId = ID;                                                 \
    explicit NAME(const std::string& name, const NodeConfig& config = {}) : BASE(name, config) {} \
  }
