// Compiles a text as `coppice test` does.
#ifndef COPPICE_TESTS_BT_CORE_TESTING_WITH_STAND_INS_H_
#define COPPICE_TESTS_BT_CORE_TESTING_WITH_STAND_INS_H_

#include <memory>
#include <string>
#include <utility>

#include "bt_core/engine/program.h"
#include "bt_core/testing/stand_in.h"

namespace coppice {

inline std::shared_ptr<const Program> CompileWithStandIns(const std::string& text,
                                                          Diagnostics& diagnostics) {
  std::optional<Project> project = Project::FromText(text, "test.xml", diagnostics);
  if (!project) return nullptr;
  const auto registry = ScenarioRegistry(*project);
  return Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
}

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_TESTING_WITH_STAND_INS_H_
