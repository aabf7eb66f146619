#include "bt_core/engine/compile/compiler_guards.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace coppice {
namespace {

// What editors write for themselves: Groot2, Groot2's live view, MoveIt Pro.
constexpr std::array<std::string_view, 9> kMetadata = {
    "_autoremap", "_description", "_collapsed", "_uid",        "_fullpath",
    "_favorite",  "_hardcoded",   "_external",  "_subtreeOnly"};

std::optional<std::size_t> GuardOf(std::string_view name) {
  const auto found = std::find(kGuardAttributes.begin(), kGuardAttributes.end(), name);
  if (found == kGuardAttributes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kGuardAttributes.begin());
}

ScriptUse UseOf(std::size_t guard) {
  return guard < static_cast<std::size_t>(Guard::kOnStart) ? ScriptUse::kCondition
                                                           : ScriptUse::kAction;
}

std::string Advice(std::string_view name) {
  if (name == "__shared_blackboard") return "in format 4 it is _autoremap=\"true\"";
  std::vector<std::string> known(kGuardAttributes.begin(), kGuardAttributes.end());
  known.insert(known.end(), kMetadata.begin(), kMetadata.end());
  return DidYouMean(name, known);
}

}  // namespace

bool GuardReader::Read(const Site& site, NodeIndex node, std::vector<GuardRecord>& guards) {
  GuardRecord record;
  record.node = node;
  record.scripts.fill(kNoScript);
  bool any = false;
  for (const Attribute& attribute : site) {
    if (attribute.name.front() != '_') continue;
    if (const std::optional<std::size_t> guard = GuardOf(attribute.name)) {
      record.scripts[*guard] = scripts_.Add(site, attribute, UseOf(*guard));
      any = true;
    } else {
      CheckMetadata(site, attribute);
    }
  }
  if (any) guards.push_back(record);
  return any;
}

void GuardReader::CheckMetadata(const Site& site, const Attribute& attribute) {
  bool truth = false;
  if (attribute.name == "_autoremap" && !ValueTraits<bool>::Parse(attribute.value, truth)) {
    problems_.Error(site.document, attribute.value_offset,
                    Quoted(attribute.value) + " is not a value for \"_autoremap\"",
                    "expected true or false");
  }
  if (std::find(kMetadata.begin(), kMetadata.end(), attribute.name) != kMetadata.end()) return;
  problems_.Error(site.document, attribute.name_offset,
                  "unknown attribute " + Quoted(attribute.name), Advice(attribute.name));
}

}  // namespace coppice
