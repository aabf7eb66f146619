// What the tests of scripts share: names that are keys of one flat blackboard.
#ifndef COPPICE_TESTS_BT_CORE_SCRIPT_FIXTURE_H_
#define COPPICE_TESTS_BT_CORE_SCRIPT_FIXTURE_H_

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/script/script.h"

namespace coppice {

/// Keys with or without the type of a port; what is not declared is made without one.
class FlatNames : public ScriptNames {
 public:
  SlotIndex Slot(std::string_view name) override {
    for (SlotIndex i{0}; i < keys_.size(); ++i) {
      if (keys_[i] == name) return i;
    }
    return Declare(name, nullptr);
  }
  const Type* TypeOf(SlotIndex slot) const override { return types_.at(slot); }
  bool IsKey(std::string_view name) const override {
    return std::find(keys_.begin(), keys_.end(), name) != keys_.end();
  }

  SlotIndex Declare(std::string_view name, const Type* type) {
    keys_.emplace_back(name);
    types_.push_back(type);
    return static_cast<SlotIndex>(keys_.size() - 1);
  }
  std::size_t size() const { return keys_.size(); }

 private:
  std::vector<std::string> keys_;
  std::vector<const Type*> types_;
};

/// Compiles and runs scripts on one blackboard.
class ScriptBench {
 public:
  template <class T>
  void Declare(std::string_view name) {
    names_.Declare(name, &TypeOf<T>());
  }
  template <class T>
  void Set(std::string_view name, const T& value) {
    SlotOf(name).value.Set(value);
  }
  Slot& SlotOf(std::string_view name) {
    const SlotIndex slot = names_.Slot(name);
    blackboard_.resize(names_.size());
    return blackboard_[slot];
  }
  Blackboard& blackboard() { return blackboard_; }
  FlatNames& names() { return names_; }
  ScriptConstants& constants() { return constants_; }

  /// Throws std::logic_error with the problems, if there are any.
  Script Compile(std::string_view text) {
    std::vector<ScriptProblem> problems;
    std::optional<Script> script = Script::Compile(text, names_, constants_, problems);
    if (!script) throw std::logic_error(problems.at(0).message);
    blackboard_.resize(names_.size());
    return *script;
  }

  /// Empty if the script is right.
  std::vector<ScriptProblem> ProblemsOf(std::string_view text) {
    std::vector<ScriptProblem> problems;
    Script::Compile(text, names_, constants_, problems);
    return problems;
  }

  bool Test(std::string_view text) {
    const Script script = Compile(text);
    return script.Test(blackboard_);
  }
  void Run(std::string_view text) {
    const Script script = Compile(text);
    script.Run(blackboard_);
  }

  /// "int64 5": type and text of what the expression gives. "error": it throws ScriptError.
  std::string ResultOf(std::string_view expression) {
    Slot& result = SlotOf("result");
    result.value.Reset();
    try {
      Run("result := (" + std::string(expression) + ")");
    } catch (const ScriptError&) {
      return "error";
    }
    return Show("result");
  }
  std::string Show(std::string_view key) {
    const Value& value = SlotOf(key).value;
    return value.has_value() ? std::string(value.type()->name) + " " + value.Print() : "empty";
  }

 private:
  FlatNames names_;
  ScriptConstants constants_;
  Blackboard blackboard_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_SCRIPT_FIXTURE_H_
