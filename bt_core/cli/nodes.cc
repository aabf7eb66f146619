#include <iostream>

#include "bt_core/base/command_line.h"
#include "bt_core/cli/plugins.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/engine/compile/models.h"
#include "bt_core/engine/compile/schema.h"

namespace coppice {
namespace {

constexpr char kUsage[] =
    "coppice nodes [--xml | --xsd] [--plugin FILE.so]...\n"
    "  The node types of the engine and of plugins, and their ports; as <TreeNodesModel> for\n"
    "  editors, or as an XML schema that text editors complete and check with.";

}  // namespace

int RunNodes(const Arguments& arguments) {
  const std::optional<Options> options =
      ParseOptions(arguments, {"--plugin"}, {"--xml", "--xsd"}, kUsage);
  if (!options) return 2;
  const std::shared_ptr<const Registry> registry = RegistryWithPlugins(*options);
  if (!registry) return 2;
  std::cout << (options->Has("--xsd")   ? WriteSchema(*registry)
                : options->Has("--xml") ? WriteModels(*registry)
                                        : DescribeNodes(*registry));
  return 0;
}

}  // namespace coppice
