// The option --plugin FILE of the verbs that need to know node types; it may be given several
// times.
#ifndef COPPICE_BT_CORE_CLI_PLUGINS_H_
#define COPPICE_BT_CORE_CLI_PLUGINS_H_

#include <memory>

#include "bt_core/base/command_line.h"
#include "bt_core/engine/registry.h"

namespace coppice {

CommandOption PluginOption();

/// The built-in node types and those of the plugins. Null, with a message to stderr, if a plugin
/// cannot be loaded.
std::shared_ptr<Registry> RegistryWithPlugins(const Options& options);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_PLUGINS_H_
