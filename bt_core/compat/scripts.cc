#include <memory>
#include <utility>
#include <vector>

#include "behaviortree_cpp/scripting/script_parser.hpp"
#include "behaviortree_cpp/tree_node.h"
#include "bt_core/script/script.h"

namespace BT {
namespace {

using coppice::Script;
using coppice::SlotIndex;

constexpr char kResult[] = "script_result_of_ParseScript";

// Each name of the script is a slot of a small blackboard of its own.
class Names final : public coppice::ScriptNames {
 public:
  SlotIndex Slot(std::string_view name) override {
    for (std::size_t k = 0; k < names_.size(); ++k) {
      if (names_[k] == name) return static_cast<SlotIndex>(k);
    }
    names_.emplace_back(name);
    return static_cast<SlotIndex>(names_.size() - 1);
  }
  const coppice::Type* TypeOf(SlotIndex) const override { return nullptr; }
  bool IsDeclared(SlotIndex) const override { return true; }
  bool IsKey(std::string_view) const override { return false; }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

struct Compiled {
  std::optional<Script> script;
  std::vector<std::string> names;
  std::string error;
};

coppice::ScriptConstants ConstantsOf(const std::shared_ptr<ScriptingEnumsRegistry>& enums) {
  coppice::ScriptConstants constants;
  constants.are_real = true;
  if (enums) constants.insert(enums->begin(), enums->end());
  return constants;
}

Compiled CompileText(const std::string& text, const coppice::ScriptConstants& constants) {
  Names names;
  std::vector<coppice::ScriptProblem> problems;
  Compiled compiled;
  compiled.script = Script::Compile(text, names, constants, problems);
  compiled.names = names.names();
  for (const coppice::ScriptProblem& problem : problems) {
    if (problem.is_warning) continue;
    compiled.error += (compiled.error.empty() ? "" : "; ") + problem.message;
    if (!problem.hint.empty()) compiled.error += " (" + problem.hint + ")";
  }
  return compiled;
}

// Where the last statement begins.
std::size_t LastStatement(const std::string& text) {
  std::size_t start = 0;
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '\'') quoted = !quoted;
    const bool more = text.find_first_not_of(" \t\r\n;", k + 1) != std::string::npos;
    if (text[k] == ';' && !quoted && more) start = k + 1;
  }
  return start;
}

// The value of the last statement is kept, if it has one.
Compiled CompileForResult(const std::string& text, const coppice::ScriptConstants& constants) {
  const std::size_t last = LastStatement(text);
  std::string end = text.substr(last);
  end.erase(end.find_last_not_of(" \t\r\n;") + 1);
  Compiled compiled =
      CompileText(StrCat(text.substr(0, last), kResult, " := (", end, ")"), constants);
  return compiled.script ? compiled : CompileText(text, constants);
}

Any Run(const Compiled& compiled, const Ast::Environment& environment) {
  coppice::Blackboard board(compiled.names.size());
  for (std::size_t k = 0; k < compiled.names.size(); ++k) {
    const auto entry = environment.vars->getEntry(compiled.names[k]);
    if (entry) board[static_cast<SlotIndex>(k)].value = entry->value.value();
  }
  try {
    compiled.script->Run(board);
  } catch (const std::exception& error) {
    throw RuntimeError(error.what());
  }
  Any result;
  for (std::size_t k = 0; k < compiled.names.size(); ++k) {
    const coppice::Slot& slot = board[static_cast<SlotIndex>(k)];
    if (slot.writes == 0) continue;
    Any value;
    value.value() = slot.value;
    if (compiled.names[k] == kResult) {
      result = std::move(value);
    } else {
      environment.vars->set(compiled.names[k], value);
    }
  }
  return result;
}

}  // namespace

Result ValidateScript(const std::string& script) {
  const Compiled compiled = CompileText(script, {});
  if (!compiled.script) return nonstd::make_unexpected(compiled.error);
  return Result();
}

Expected<ScriptFunction> ParseScript(const std::string& script) {
  const Result valid = ValidateScript(script);
  if (!valid) return nonstd::make_unexpected(valid.error());
  return ScriptFunction([script](Ast::Environment& environment) {
    const Compiled compiled = CompileForResult(script, ConstantsOf(environment.enums));
    if (!compiled.script) throw RuntimeError(compiled.error);
    return Run(compiled, environment);
  });
}

Expected<Any> ParseScriptAndExecute(Ast::Environment& env, const std::string& script) {
  const Expected<ScriptFunction> function = ParseScript(script);
  if (!function) return nonstd::make_unexpected(function.error());
  try {
    return (*function)(env);
  } catch (const std::exception& error) {
    return nonstd::make_unexpected(std::string(error.what()));
  }
}

}  // namespace BT
