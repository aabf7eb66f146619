// Halts the child when it takes too long. The built-in node; what it does is in docs/semantics.md.
#pragma once

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

COPPICE_COMPAT_BUILT_IN(TimeoutNode, internal::BuiltIn<DecoratorNode>, "Timeout");

}  // namespace BT
