#include "bt_core/live/debug/hook_condition.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/live/debug/scope_keys.h"

namespace coppice {
namespace {

// The keys of a compiled tree. It cannot get new ones, so a name that is none is remembered.
class KnownNames : public ScriptNames {
 public:
  KnownNames(const Program& program, ScopeIndex scope) : program_(program), scope_(scope) {}

  SlotIndex Slot(std::string_view name) override {
    const SlotIndex slot = FindKey(program_, scope_, name);
    if (slot == kNoSlot && unknown_.empty()) unknown_ = name;
    return slot;
  }
  const Type* TypeOf(SlotIndex slot) const override {
    return slot == kNoSlot ? nullptr : program_.layout.slots[slot].type;
  }
  bool IsKey(std::string_view name) const override {
    return FindKey(program_, scope_, name) != kNoSlot;
  }

  std::string_view unknown() const { return unknown_; }

 private:
  const Program& program_;
  ScopeIndex scope_;
  std::string_view unknown_;
};

class AnyNames : public ScriptNames {
 public:
  SlotIndex Slot(std::string_view) override { return {}; }
  const Type* TypeOf(SlotIndex) const override { return nullptr; }
  bool IsKey(std::string_view) const override { return false; }
};

Problem At(std::string_view script, std::size_t offset, const std::string& message,
           const std::string& hint = {}) {
  const std::string_view before = script.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t column = offset - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
  return {"condition:" + std::to_string(line) + ":" + std::to_string(column) + ": " + message +
          (hint.empty() ? "" : " (" + hint + ")")};
}

Outcome CheckResult(std::string_view text, const std::optional<Script>& script,
                    const std::vector<ScriptProblem>& found) {
  if (!found.empty()) return At(text, found[0].offset, found[0].message, found[0].hint);
  if (!script->writes().empty()) {
    return At(text, 0, "a condition cannot assign to a key", "\"==\" compares");
  }
  return {};
}

}  // namespace

Expected<Script> CompileCondition(std::string_view text, const Program& program, ScopeIndex scope) {
  KnownNames names(program, scope);
  std::vector<ScriptProblem> found;
  std::optional<Script> script =
      Script::Compile(text, names, program.registry->script_constants(), found);
  if (Outcome result = CheckResult(text, script, found); !result) {
    return Problem{std::move(result).problem()};
  }
  if (names.unknown().empty()) return *std::move(script);
  const std::string name(names.unknown());
  return At(text, text.find(name), "no node around here uses a key \"" + name + "\"",
            DidYouMean(name, KeysAround(program, scope)));
}

Outcome CheckCondition(std::string_view text, const ScriptConstants& constants) {
  AnyNames names;
  std::vector<ScriptProblem> found;
  const std::optional<Script> script = Script::Compile(text, names, constants, found);
  return CheckResult(text, script, found);
}

}  // namespace coppice
