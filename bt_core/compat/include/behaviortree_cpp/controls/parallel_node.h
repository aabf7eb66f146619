// All children in each tick, until enough are done.
// The built-in node; what it does is in docs/semantics.md.
#pragma once

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

COPPICE_COMPAT_BUILT_IN(ParallelNode, internal::BuiltIn<ControlNode>, "Parallel");

}  // namespace BT
