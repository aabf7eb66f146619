#include "editor/document/script_check.h"

#include <vector>

#include "bt_core/script/script.h"

namespace coppice::editor {
namespace {

class AnyNames : public ScriptNames {
 public:
  SlotIndex Slot(std::string_view) override { return SlotIndex{0}; }
  const Type* TypeOf(SlotIndex) const override { return nullptr; }
  bool IsKey(std::string_view) const override { return false; }
};

}  // namespace

std::string ScriptProblemOf(std::string_view script) {
  AnyNames names;
  std::vector<ScriptProblem> problems;
  Script::Compile(script, names, {}, problems);
  if (problems.empty()) return {};
  const ScriptProblem& first = problems.front();
  return "column " + std::to_string(first.offset + 1) + ": " + first.message +
         (first.hint.empty() ? "" : " (" + first.hint + ")");
}

}  // namespace coppice::editor
