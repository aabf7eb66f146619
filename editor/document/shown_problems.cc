#include "editor/document/shown_problems.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace coppice::editor {
namespace {

constexpr std::string_view kTypeBefore = "node type \"";
constexpr std::string_view kTypeBehind = "\" is not built in: its ports are not checked";
constexpr std::string_view kNoModel = " no model, so ";
constexpr char kNoRoot[] = " has 0 root nodes";
constexpr std::size_t kNamed = 6;  // types that the remark names

// The type that no model describes, if that is the problem. One that may be misspelt stays alone.
std::string TypeWithoutModel(const Diagnostic& problem) {
  const std::string_view message = problem.message;
  const std::size_t end = message.find(kTypeBehind);
  if (!problem.hint.empty() || message.substr(0, kTypeBefore.size()) != kTypeBefore ||
      end == std::string_view::npos) {
    return {};
  }
  return std::string(message.substr(kTypeBefore.size(), end - kTypeBefore.size()));
}

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
    const std::string type = TypeWithoutModel(problem);
    if (!type.empty()) {
      if (types.empty()) remark = problem;
      if (std::find(types.begin(), types.end(), type) == types.end()) types.push_back(type);
    } else if (!is_new || problem.message.find(kNoRoot) == std::string::npos) {
      shown.push_back(problem);
    }
  }
  if (types.empty()) return shown;
  remark.message = Remark(types);
  shown.push_back(remark);
  return shown;
}

bool IsAboutModels(const Diagnostic& problem) {
  return problem.message.find(kNoModel) != std::string::npos;
}

}  // namespace coppice::editor
