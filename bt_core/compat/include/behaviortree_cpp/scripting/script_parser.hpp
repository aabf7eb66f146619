// Scripts, outside of a tree: for tests of nodes and for conditions that code sets.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <unordered_map>

#include "behaviortree_cpp/basic_types.h"
#include "behaviortree_cpp/blackboard.h"

namespace BT {

using ScriptingEnumsRegistry = std::unordered_map<std::string, int>;

namespace Ast {
/// Where a script finds its names.
struct Environment {
  Blackboard::Ptr vars;
  std::shared_ptr<ScriptingEnumsRegistry> enums;
};
}  // namespace Ast

using ScriptFunction = std::function<Any(Ast::Environment& env)>;

/// Why the text is no script, or nothing.
Result ValidateScript(const std::string& script);
/// The function throws RuntimeError where the script cannot be run; its result is the value of the
/// last statement.
Expected<ScriptFunction> ParseScript(const std::string& script);
Expected<Any> ParseScriptAndExecute(Ast::Environment& env, const std::string& script);

}  // namespace BT
