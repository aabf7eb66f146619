// A node type for the installed `coppice`.
#include "bt_core/engine/plugin.h"

COPPICE_PLUGIN(registry) {
  registry.Condition("IsOdd", {"number"}, [](int number) { return number % 2 == 1; });
}
