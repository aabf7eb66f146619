// A plugin: a shared library with node types, loaded by a program that does not know them.
//
//   #include "bt_core/engine/plugin.h"
//
//   class IsDark : public coppice::Condition { ... };
//
//   COPPICE_PLUGIN(registry) {
//     registry.Register<IsDark>("IsDark");
//     registry.Condition("IsNight", [] { return true; });
//   }
//
// CMake builds it with coppice_add_plugin(my_nodes my_nodes.cc), `coppice check`, `nodes` and `run`
// take it as --plugin my_nodes.so, and a program of one's own calls Registry::LoadPlugin and is
// linked with coppice_load_plugins(my_program).
//
// Plugin and program share C++ classes, so both must be built with the same version of Coppice and
// compatible compilers; loading checks what can be checked. A plugin must not link the engine
// itself: there would be two.
#ifndef COPPICE_BT_CORE_ENGINE_PLUGIN_H_
#define COPPICE_BT_CORE_ENGINE_PLUGIN_H_

#include <cstdint>

#include "bt_core/base/version.h"
#include "bt_core/engine/registry.h"

namespace coppice {

/// What a plugin says of itself.
struct PluginInterface {
  const char* version;         ///< of the headers that it was built with; stays the first member
  std::uint32_t sizes;         ///< of the classes that it shares with the program
  const Type* type_of_double;  ///< the program's own, if plugin and program share one engine
  void (*add_to)(Registry& registry);

  static constexpr std::uint32_t kSizes = sizeof(Registry) + 37 * sizeof(Registry::Entry) +
                                          1009 * sizeof(UserNode) + 10007 * sizeof(Slot) +
                                          100003 * sizeof(Type);
};

/// The name of the function by which a plugin is found; it returns a const PluginInterface*.
inline constexpr char kPluginFunction[] = "coppice_plugin";

}  // namespace coppice

/// Followed by the body of a function that gets a coppice::Registry&. Once in a library. What it
/// throws is the reason why the plugin is not loaded.
#define COPPICE_PLUGIN(registry)                                                                   \
  static void CoppiceAddTo(coppice::Registry& registry);                                           \
  extern "C" __attribute__((visibility("default"))) const coppice::PluginInterface*                \
  coppice_plugin() {                                                                               \
    static const coppice::PluginInterface interface = {coppice::kVersion,                          \
                                                       coppice::PluginInterface::kSizes,           \
                                                       &coppice::TypeOf<double>(), &CoppiceAddTo}; \
    return &interface;                                                                             \
  }                                                                                                \
  static void CoppiceAddTo([[maybe_unused]] coppice::Registry& registry)

#endif  // COPPICE_BT_CORE_ENGINE_PLUGIN_H_
