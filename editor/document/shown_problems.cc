#include "editor/document/shown_problems.h"

#include <algorithm>
#include <string>

namespace coppice::editor {
namespace {

constexpr std::size_t kNamed = 6;  // types that the remark names

std::string Remark(const std::vector<std::string>& types) {
  if (types.size() == 1) return "type " + types[0] + " has no model, so its ports are not checked";
  std::string text = std::to_string(types.size()) + " types have no model, so their ports are not ";
  text += "checked: ";
  const std::size_t named = types.size() <= kNamed + 1 ? types.size() : kNamed;
  for (std::size_t i = 0; i < named; ++i) text += (i == 0 ? "" : ", ") + types[i];
  const std::size_t more = types.size() - named;
  return more == 0 ? text : text + " and " + std::to_string(more) + " more";
}

}  // namespace

std::vector<Diagnostic> ShownProblems(const std::vector<Diagnostic>& problems, bool is_new) {
  std::vector<Diagnostic> shown;
  std::vector<std::string> types;
  Diagnostic remark;
  for (const Diagnostic& problem : problems) {
    if (problem.about.kind == ProblemKind::kNoModel) {
      const std::string& type = problem.about.name;
      if (types.empty()) remark = problem;
      if (std::find(types.begin(), types.end(), type) == types.end()) types.push_back(type);
    } else if (!is_new || problem.about.kind != ProblemKind::kEmptyTree) {
      shown.push_back(problem);
    }
  }
  if (types.empty()) return shown;
  remark.message = Remark(types);
  if (types.size() > 1) remark.about.name.clear();
  shown.push_back(remark);
  return shown;
}

bool IsAboutModels(const Diagnostic& problem) {
  return problem.about.kind == ProblemKind::kNoModel;
}

}  // namespace coppice::editor
