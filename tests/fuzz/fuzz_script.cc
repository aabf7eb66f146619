#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/data/standard_types.h"
#include "bt_core/script/script.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {
namespace {

struct Key {
  std::string name;
  const Type* type;
};

class Keys : public ScriptNames {
 public:
  Keys()
      : keys_{{"a", nullptr},
              {"b", &coppice::TypeOf<bool>()},
              {"d", &coppice::TypeOf<double>()},
              {"i", &coppice::TypeOf<int>()},
              {"u", &coppice::TypeOf<std::uint64_t>()},
              {"f", &coppice::TypeOf<float>()},
              {"s", &coppice::TypeOf<std::string>()},
              {"e", &coppice::TypeOf<Status>()},
              {"v", &coppice::TypeOf<std::vector<int>>()}} {}

  SlotIndex Slot(std::string_view name) override {
    for (SlotIndex i{0}; i < keys_.size(); ++i) {
      if (keys_[i].name == name) return i;
    }
    keys_.push_back({std::string(name), nullptr});
    return static_cast<SlotIndex>(keys_.size() - 1);
  }
  const Type* TypeOf(SlotIndex slot) const override { return keys_.at(slot).type; }
  bool IsKey(std::string_view) const override { return false; }

  // All keys that have a type have a value.
  Blackboard MakeBlackboard() const {
    Blackboard blackboard(keys_.size());
    for (SlotIndex i{0}; i < keys_.size(); ++i) {
      const Type* const type = keys_[i].type;
      if (type && !blackboard[i].value.Parse(*type, "1")) std::abort();
    }
    return blackboard;
  }

  // What has a type keeps it.
  void Check(const Blackboard& blackboard) const {
    for (SlotIndex i{0}; i < keys_.size(); ++i) {
      if (keys_[i].type && blackboard[i].value.type() != keys_[i].type) std::abort();
    }
  }

 private:
  std::vector<Key> keys_;
};

}  // namespace

int FuzzScript(std::string_view bytes) {
  Keys keys;
  ScriptConstants constants;
  AddEnumerators(EnumeratorsOf<Status>(), constants);
  std::vector<ScriptProblem> problems;
  const std::optional<Script> script =
      Script::Compile(bytes, keys, constants, problems, ScriptUse::kCondition);
  const auto is_error = [](const ScriptProblem& problem) { return !problem.is_warning; };
  const bool has_errors = std::any_of(problems.begin(), problems.end(), is_error);
  if (script.has_value() == has_errors) std::abort();
  for (const ScriptProblem& problem : problems) {
    if (problem.offset > bytes.size() || problem.message.empty()) std::abort();
  }
  if (!script) return 0;
  Blackboard blackboard = keys.MakeBlackboard();
  int reached = 2;
  try {
    script->Run(blackboard);
    script->Test(blackboard);
  } catch (const ScriptError&) {
    reached = 1;
  }
  keys.Check(blackboard);
  return reached;
}

}  // namespace coppice::fuzz
