#include "bt_core/nodes/node_type.h"

#include "bt_core/nodes/built_in_tables.h"

namespace coppice {

const std::vector<BuiltIn>& BuiltIns() {
  static const std::vector<BuiltIn> all = [] {
    std::vector<BuiltIn> nodes = BuiltInControls();
    for (const auto& group : {BuiltInDecorators(), BuiltInLeaves()}) {
      nodes.insert(nodes.end(), group.begin(), group.end());
    }
    return nodes;
  }();
  return all;
}

}  // namespace coppice
