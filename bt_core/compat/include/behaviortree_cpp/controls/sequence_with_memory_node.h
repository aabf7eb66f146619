// A sequence that resumes at the child that failed.
// The built-in node; what it does is in docs/semantics.md.
#pragma once

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

COPPICE_COMPAT_BUILT_IN(SequenceWithMemory, internal::BuiltIn<ControlNode>, "SequenceWithMemory");

}  // namespace BT
