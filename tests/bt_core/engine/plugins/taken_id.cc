// Adds one node type, and then one that there is.
#include "bt_core/engine/plugin.h"

COPPICE_PLUGIN(registry) {
  registry.Condition("New", [] { return true; });
  registry.Condition("Sequence", [] { return true; });
}
