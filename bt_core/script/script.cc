#include "bt_core/script/script.h"

namespace coppice {

std::optional<Script> Script::Compile(std::string_view, ScriptNames&, const ScriptConstants&,
                                      std::vector<ScriptProblem>& problems) {
  problems.push_back({0, "scripts are not supported yet", ""});
  return std::nullopt;
}

void Script::Run(Blackboard&) const {}

bool Script::Test(Blackboard&) const { return false; }

}  // namespace coppice
