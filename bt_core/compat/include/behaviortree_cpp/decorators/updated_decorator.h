// Ticks the child if a key has been written. The built-in nodes; what they do is in
// docs/semantics.md.
#pragma once

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

COPPICE_COMPAT_BUILT_IN(EntryUpdatedDecorator, internal::BuiltIn<DecoratorNode>,
                        "SkipUnlessUpdated");

}  // namespace BT
