// Compiles a text for a simulation.
#ifndef COPPICE_TESTS_EDITOR_SIMULATION_SIMULATED_TEXT_H_
#define COPPICE_TESTS_EDITOR_SIMULATION_SIMULATED_TEXT_H_

#include <memory>
#include <stdexcept>
#include <string>

#include "editor/simulation/open_tree.h"

namespace coppice::editor {

/// `trees`: <BehaviorTree> elements, the first one with the ID Main.
inline std::shared_ptr<const Program> Compiled(const std::string& trees) {
  OpenProject files;
  files.Create("test.xml",
               R"(<root BTCPP_format="4" main_tree_to_execute="Main">)" + trees + "</root>");
  Diagnostics diagnostics;
  auto program = CompileOpenTree(files, "test.xml", "", nullptr, diagnostics);
  if (!program) throw std::invalid_argument(diagnostics.ToString());
  return program;
}

inline std::shared_ptr<const Program> CompiledRoot(const std::string& root) {
  return Compiled(R"(<BehaviorTree ID="Main">)" + root + "</BehaviorTree>");
}

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_SIMULATION_SIMULATED_TEXT_H_
