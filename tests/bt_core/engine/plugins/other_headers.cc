// Says that its classes have other sizes.
#include "bt_core/engine/plugin.h"

extern "C" const coppice::PluginInterface* coppice_plugin() {
  static const coppice::PluginInterface interface = {
      coppice::kVersion, coppice::PluginInterface::kSizes + 1, nullptr, nullptr};
  return &interface;
}
