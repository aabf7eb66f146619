// patrol_robot TREE.xml: runs the tree until it is done.
#include <iostream>

#include "bt_core/engine/executor.h"
#include "bt_core/engine/runner.h"
#include "patrol_leaves/leaves.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: patrol_robot TREE.xml\n";
    return 2;
  }
  auto registry = std::make_shared<coppice::Registry>();
  patrol::RegisterLeaves(*registry);
  coppice::Diagnostics diagnostics;
  const auto program = coppice::CompileFile(argv[1], registry, diagnostics);
  std::cerr << diagnostics.ToString();
  if (!program) return 2;
  coppice::WallClock clock;
  coppice::Executor executor(program, clock);
  return coppice::Run(executor) == coppice::Status::kSuccess ? 0 : 1;
}
