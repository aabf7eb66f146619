// A fallback that starts at its first child in every tick.
// The built-in node; what it does is in docs/semantics.md.
#pragma once

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

COPPICE_COMPAT_BUILT_IN(ReactiveFallback, internal::BuiltIn<ControlNode>, "ReactiveFallback");

}  // namespace BT
