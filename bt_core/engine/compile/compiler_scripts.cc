#include "bt_core/engine/compile/compiler_scripts.h"

#include <optional>
#include <string>
#include <utility>

#include "bt_core/engine/compile/type_names.h"
#include "bt_core/model/keys.h"

namespace coppice {
namespace {

// The names of a script are keys of the scope of its node.
class NamesInScope : public ScriptNames {
 public:
  NamesInScope(KeyTable& keys, const SlotTypes& types, ScopeIndex scope)
      : keys_(keys), types_(types), scope_(scope) {}
  SlotIndex Slot(std::string_view name) override { return keys_.ResolveCopy(name, scope_); }
  // Of a type without more than a name, nobody knows what a script can do with it.
  const Type* TypeOf(SlotIndex slot) const override {
    const Type* const type = types_.Of(slot);
    return type && HasOnlyAName(*type) ? nullptr : type;
  }
  bool IsDeclared(SlotIndex slot) const override { return types_.IsDeclared(slot); }
  bool IsKey(std::string_view name) const override { return keys_.Has(name, scope_); }

 private:
  KeyTable& keys_;
  const SlotTypes& types_;
  ScopeIndex scope_;
};

}  // namespace

ScriptIndex ScriptTable::Add(const Site& site, const Attribute& attribute, ScriptUse use) {
  if (!KeyOf(attribute.value, attribute.name).empty()) {
    problems_.Error(site.document, attribute.value_offset,
                    "a script cannot come from the blackboard: " + Quoted(attribute.value),
                    "it is compiled when the tree is loaded; write the script itself, in which a "
                    "key stands without braces");
    return kNoScript;
  }
  return Add({&site.document, &attribute, site.element.offset, attribute.value, site.scope, use});
}

ScriptIndex ScriptTable::AddDefault(const Site& site, std::string_view text, ScriptUse use) {
  return Add({&site.document, nullptr, site.element.offset, text, site.scope, use});
}

ScriptIndex ScriptTable::Add(const Pending& pending) {
  constexpr std::size_t kOfScript = 800, kOfLetter = 60;  // with its keys, as measured
  bytes_ += kOfScript + kOfLetter * pending.text.size();
  pending_.push_back(pending);
  return static_cast<ScriptIndex>(pending_.size() - 1);
}

void ScriptTable::Compile(const ScriptConstants& constants, std::vector<Script>& scripts) {
  scripts.reserve(pending_.size());
  std::vector<ScriptProblem> found;
  for (const Pending& pending : pending_) {
    NamesInScope names(keys_, types_, pending.scope);
    found.clear();
    std::optional<Script> script =
        Script::Compile(pending.text, names, constants, found, pending.use);
    if (script) scripts.push_back(*std::move(script));
    for (ScriptProblem& problem : found) Report(pending, std::move(problem));
  }
}

void ScriptTable::Report(const Pending& pending, ScriptProblem problem) {
  const std::uint32_t offset =
      pending.attribute ? pending.document->OffsetInValue(*pending.attribute, problem.offset)
                        : pending.offset;
  problems_.Add(problem.is_warning ? Severity::kWarning : Severity::kError, *pending.document,
                offset, std::move(problem.message), std::move(problem.hint),
                {ProblemKind::kInScript, {}});
}

}  // namespace coppice
