// One child after the other until one succeeds.
// The built-in node; what it does is in docs/semantics.md.
#pragma once

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

COPPICE_COMPAT_BUILT_IN(FallbackNode, internal::BuiltIn<ControlNode>, "Fallback");
COPPICE_COMPAT_BUILT_IN(AsyncFallback, internal::BuiltIn<ControlNode>, "AsyncFallback");

}  // namespace BT
