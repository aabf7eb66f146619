// Ticks the child until it has completed once.
// The built-in node; what it does is in docs/semantics.md.
#pragma once

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

COPPICE_COMPAT_BUILT_IN(RunOnceNode, internal::BuiltIn<DecoratorNode>, "RunOnce");

}  // namespace BT
