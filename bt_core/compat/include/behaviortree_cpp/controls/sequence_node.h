// One child after the other. The built-in node; what it does is in docs/semantics.md.
#pragma once

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

COPPICE_COMPAT_BUILT_IN(SequenceNode, internal::BuiltIn<ControlNode>, "Sequence");
COPPICE_COMPAT_BUILT_IN(AsyncSequence, internal::BuiltIn<ControlNode>, "AsyncSequence");

}  // namespace BT
