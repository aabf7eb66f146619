#include "bt_core/cli/plugins.h"

#include <iostream>
#include <stdexcept>

namespace coppice {

CommandOption PluginOption() {
  return CommandOption::Text("--plugin", "FILE.so",
                             "a library with node types; may be given several times");
}

std::shared_ptr<Registry> RegistryWithPlugins(const Options& options) {
  auto registry = std::make_shared<Registry>();
  for (const std::string& path : options.GetAll("--plugin")) {
    try {
      registry->LoadPlugin(path);
    } catch (const std::runtime_error& error) {
      std::cerr << error.what() << "\n";
      return nullptr;
    }
  }
  return registry;
}

}  // namespace coppice
