// A sequence with a last child for when it fails.
// The built-in node; what it does is in docs/semantics.md.
#pragma once

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

COPPICE_COMPAT_BUILT_IN(TryCatchNode, internal::BuiltIn<ControlNode>, "TryCatch");

}  // namespace BT
