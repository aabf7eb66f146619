// The tree that these programs run: it succeeds in its third tick, two simulated seconds later.
#ifndef OUTSIDE_TREE_H_
#define OUTSIDE_TREE_H_

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "bt_core/engine/executor.h"

inline constexpr char kTree[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
  <Sequence><Script code="n := 3"/><Sleep msec="2000"/></Sequence>
</BehaviorTree></root>)";

inline std::shared_ptr<const coppice::Program> CompileTree() {
  coppice::Diagnostics diagnostics;
  auto project = coppice::Project::FromText(kTree, "tree.h", diagnostics);
  if (!project) std::abort();
  return coppice::Compile(std::make_shared<const coppice::Project>(*std::move(project)),
                          std::make_shared<coppice::Registry>(), diagnostics);
}

#endif  // OUTSIDE_TREE_H_
