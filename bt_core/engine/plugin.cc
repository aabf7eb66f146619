#include "bt_core/engine/plugin.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace coppice {
namespace {

// The types of a plugin lie in it and may be referred to by any value, so it is never unloaded.
void* Open(const std::string& path) {
  // Without a slash dlopen would look elsewhere.
  const std::string file = path.find('/') == std::string::npos ? "./" + path : path;
  if (void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) return library;
  std::string problem = dlerror();
  if (problem.compare(0, file.size() + 2, file + ": ") == 0) problem.erase(0, file.size() + 2);
  if (problem.find("coppice") != std::string::npos) {
    problem += " (the program must be linked with coppice_load_plugins)";
  }
  throw std::runtime_error(problem);
}

const PluginInterface& InterfaceOf(const std::string& path) {
  void* const function = dlsym(Open(path), kPluginFunction);
  if (!function) throw std::runtime_error("is no plugin of Coppice: it has no COPPICE_PLUGIN");
  return *reinterpret_cast<const PluginInterface* (*)()>(function)();
}

void Check(const PluginInterface& plugin) {
  if (plugin.version != std::string(kVersion)) {
    throw std::runtime_error(std::string("was built for Coppice ") + plugin.version +
                             ", this is Coppice " + kVersion);
  }
  if (plugin.sizes != PluginInterface::kSizes) {
    throw std::runtime_error(
        "was built with other headers or another standard library than this "
        "program");
  }
  if (plugin.type_of_double != &TypeOf<double>()) {
    throw std::runtime_error(
        "brings an engine of its own or hides its types: link it without coppice::bt_core "
        "(coppice_add_plugin), with the default visibility, and the program with "
        "coppice_load_plugins");
  }
}

}  // namespace

void Registry::LoadPlugin(const std::string& path) {
  try {
    const PluginInterface& plugin = InterfaceOf(path);
    Check(plugin);
    Registry with_plugin = *this;
    plugin.add_to(with_plugin);
    *this = std::move(with_plugin);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace coppice
