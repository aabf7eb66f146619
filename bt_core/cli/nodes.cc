#include <iostream>

#include "bt_core/base/command_line.h"
#include "bt_core/cli/plugins.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/engine/models.h"

namespace coppice {
namespace {

constexpr char kUsage[] =
    "coppice nodes [--xml] [--plugin FILE.so]...\n"
    "  The node types of the engine and of plugins, and their ports.";

}  // namespace

int RunNodes(const Arguments& arguments) {
  const std::optional<Options> options = ParseOptions(arguments, {"--plugin"}, {"--xml"}, kUsage);
  if (!options) return 2;
  const std::shared_ptr<const Registry> registry = RegistryWithPlugins(*options);
  if (!registry) return 2;
  std::cout << (options->Has("--xml") ? WriteModels(*registry) : DescribeNodes(*registry));
  return 0;
}

}  // namespace coppice
