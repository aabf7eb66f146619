#include "robot_app/processes/config/variables.h"

namespace coppice::robot::processes {
namespace {

using Report = std::function<void(const std::string& message, const std::string& hint)>;

struct Context {
  const Variables& variables;
  Advisor& advisor;
  const Report& report;
};

constexpr int kDeepest = 16;  // defaults within defaults

std::string Fill(const std::string& text, const Context& context, int depth);

// Of the brace that was opened just before `position`; npos if there is none.
std::size_t MatchingBrace(const std::string& text, std::size_t position) {
  int open = 1;
  for (; position < text.size(); ++position) {
    if (text.compare(position, 2, "${") == 0) ++open;
    if (text[position] == '}' && --open == 0) return position;
  }
  return std::string::npos;
}

std::string Lookup(const std::string& expression, const Context& context, int depth) {
  const std::size_t separator = expression.find(":-");
  const std::string name = expression.substr(0, separator);
  const auto found = context.variables.find(name);
  if (found != context.variables.end()) return found->second;
  if (separator != std::string::npos) {
    return Fill(expression.substr(separator + 2), context, depth + 1);
  }
  const std::string hint = context.advisor.Advise(name, context.variables,
                                                  [](const auto& known) { return known.first; });
  context.report("variable \"" + name + "\" has no value",
                 hint.empty() ? "give it with --set " + name + "=VALUE" : hint);
  return "";
}

std::string Fill(const std::string& text, const Context& context, int depth) {
  if (depth > kDeepest) {
    context.report("more than " + std::to_string(kDeepest) + " defaults within each other", "");
    return "";
  }
  std::string filled;
  std::size_t position = 0;
  while (true) {
    const std::size_t begin = text.find("${", position);
    filled += text.substr(position, begin - position);
    if (begin == std::string::npos) return filled;
    const std::size_t end = MatchingBrace(text, begin + 2);
    if (end == std::string::npos) {
      context.report("\"${\" without \"}\" in \"" + text + "\"", "");
      return filled;
    }
    filled += Lookup(text.substr(begin + 2, end - begin - 2), context, depth);
    if (filled.size() > kLongestFilled) {
      context.report("stands for more than " + std::to_string(kLongestFilled) + " bytes", "");
      return "";
    }
    position = end + 1;
  }
}

}  // namespace

std::string FillVariables(const std::string& text, const Variables& variables, Advisor& advisor,
                          const Report& report) {
  return Fill(text, {variables, advisor, report}, 0);
}

}  // namespace coppice::robot::processes
