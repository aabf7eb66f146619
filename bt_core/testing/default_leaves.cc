#include "bt_core/testing/default_leaves.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/testing/stand_in.h"

namespace coppice {
namespace {

constexpr Duration kActionTime = std::chrono::seconds(1);
constexpr Chances kActionChances = {4, 1, 0, Duration(0), std::chrono::seconds(2)};
constexpr Chances kConditionChances = {
    1, 1, 0, Duration(0), Duration(0), Duration(0), std::chrono::seconds(5)};

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

bool IsValue(const std::string& text, const Type& type) {
  Value value;
  return value.Parse(type, text);
}

// A few that make a difference to whoever reads them.
std::vector<std::string> SomeValues(const PortDeclaration& port) {
  if (!port.type) return {};
  std::vector<std::string> texts;
  if (port.default_text && IsValue(*port.default_text, *port.type)) {
    texts.push_back(*port.default_text);
  }
  if (port.type == &TypeOf<std::string>()) {
    texts.push_back(port.name);
    return texts;
  }
  for (const char* const text : {"true", "false", "0", "0.5", "1", "2"}) {
    const bool is_word = std::isalpha(static_cast<unsigned char>(text[0])) != 0;
    if (is_word == (port.type == &TypeOf<bool>()) && IsValue(text, *port.type)) {
      texts.emplace_back(text);
    }
  }
  return texts;
}

MockScript RandomScript(const Registry::Entry& entry) {
  MockScript script;
  script.chances = IsCondition(entry) ? kConditionChances : kActionChances;
  for (const PortDeclaration& port : entry.declarations) {
    const bool is_output =
        port.direction == PortDirection::kOutput || port.direction == PortDirection::kInOut;
    std::vector<std::string> texts = is_output ? SomeValues(port) : std::vector<std::string>();
    if (!texts.empty()) script.outputs_by_chance.emplace_back(port.name, std::move(texts));
  }
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

std::vector<PlacedRule> RandomLeaves(const Program& program, const std::vector<PlacedRule>& given) {
  std::vector<PlacedRule> rules = given;
  for (PlacedRule& otherwise : RulesByType(program, RandomScript)) {
    const bool is_given = std::any_of(given.begin(), given.end(), [&](const PlacedRule& rule) {
      return FitsWildcards(rule.rule.pattern, otherwise.rule.pattern);
    });
    if (!is_given) rules.push_back(std::move(otherwise));
  }
  return rules;
}

}  // namespace coppice
