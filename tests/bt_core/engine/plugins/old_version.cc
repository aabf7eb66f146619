// Says that it was built for an older Coppice.
#include "bt_core/engine/plugin.h"

extern "C" const coppice::PluginInterface* coppice_plugin() {
  static const coppice::PluginInterface interface = {"0.0.9", 0, nullptr, nullptr};
  return &interface;
}
