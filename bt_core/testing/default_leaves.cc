#include "bt_core/testing/default_leaves.h"

#include <cctype>
#include <set>
#include <string>

#include "bt_core/testing/stand_in.h"

namespace coppice {
namespace {

constexpr Duration kActionTime = std::chrono::seconds(1);
constexpr Chances kActionChances = {4, 1, 0, Duration(0), std::chrono::seconds(2)};
constexpr Chances kConditionChances = {1, 1, 0, Duration(0), Duration(0)};

bool SoundsLikeACondition(const std::string& id) {
  for (const std::string verb : {"Is", "Has"}) {
    const bool fits = id.size() > verb.size() && id.compare(0, verb.size(), verb) == 0;
    if (fits && std::isupper(static_cast<unsigned char>(id[verb.size()]))) return true;
  }
  return false;
}

bool IsCondition(const Registry::Entry& entry) {
  return entry.manifest.category == NodeCategory::kCondition ||
         SoundsLikeACondition(entry.manifest.id);
}

MockScript DefaultScript(const Registry::Entry& entry) {
  MockScript script;
  script.results = {Status::kSuccess};
  if (!IsCondition(entry)) script.duration = kActionTime;
  return script;
}

MockScript RandomScript(const Registry::Entry& entry) {
  MockScript script;
  script.chances = IsCondition(entry) ? kConditionChances : kActionChances;
  return script;
}

template <class ScriptOf>
std::vector<PlacedRule> RulesByType(const Program& program, ScriptOf script_of) {
  std::set<std::string> ids;
  for (const LeafRecord& record : program.leaves) ids.insert(program.Id(record.node));
  std::vector<PlacedRule> rules;
  for (const std::string& id : ids) {
    const Registry::Entry* entry = program.registry->Find(id);
    if (entry && IsStandIn(*entry)) rules.push_back({{}, {"<" + id + ">", script_of(*entry)}});
  }
  return rules;
}

}  // namespace

std::vector<PlacedRule> DefaultLeaves(const Program& program) {
  return RulesByType(program, DefaultScript);
}

std::vector<PlacedRule> RandomLeaves(const Program& program) {
  return RulesByType(program, RandomScript);
}

}  // namespace coppice
