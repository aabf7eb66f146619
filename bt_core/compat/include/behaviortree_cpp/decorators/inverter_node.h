// SUCCESS becomes FAILURE and the reverse. The built-in node; what it does is in docs/semantics.md.
#pragma once

#include "behaviortree_cpp/internal/built_in.h"

namespace BT {

COPPICE_COMPAT_BUILT_IN(InverterNode, internal::BuiltIn<DecoratorNode>, "Inverter");

}  // namespace BT
