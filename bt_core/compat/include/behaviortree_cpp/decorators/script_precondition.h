// Ticks the child if a script says so. The built-in node; what it does is in docs/semantics.md.
#pragma once

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

COPPICE_COMPAT_BUILT_IN(PreconditionNode, internal::BuiltIn<DecoratorNode>, "Precondition");

}  // namespace BT
