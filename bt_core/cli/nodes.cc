#include <iostream>

#include "bt_core/base/command_line.h"
#include "bt_core/cli/plugins.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/engine/compile/models.h"
#include "bt_core/engine/compile/schema.h"

namespace coppice {

const Command& NodesCommand() {
  static const Command command{
      "coppice nodes",
      "list the node types and their ports",
      {},
      "Prints the node types of the engine and of plugins, and their ports.",
      {CommandOption::Flag("--xml", "as <TreeNodesModel>, for editors"),
       CommandOption::Flag("--xsd", "as an XML schema that text editors complete and check with"),
       PluginOption()}};
  return command;
}

int RunNodes(const Arguments& arguments) {
  const Options options = ParseOptions(NodesCommand(), arguments);
  if (options.exit) return *options.exit;
  const std::shared_ptr<const Registry> registry = RegistryWithPlugins(options);
  if (!registry) return 2;
  std::cout << (options.Has("--xsd")   ? WriteSchema(*registry)
                : options.Has("--xml") ? WriteModels(*registry)
                                       : DescribeNodes(*registry));
  return 0;
}

}  // namespace coppice
