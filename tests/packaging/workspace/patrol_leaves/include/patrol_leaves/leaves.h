// The leaves of the patrol.
#ifndef PATROL_LEAVES_LEAVES_H_
#define PATROL_LEAVES_LEAVES_H_

#include "bt_core/engine/registry.h"

namespace patrol {

void RegisterLeaves(coppice::Registry& registry);

}  // namespace patrol

#endif  // PATROL_LEAVES_LEAVES_H_
