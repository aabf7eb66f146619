// Scripts: the small expression language of guards, hooks, Script and ScriptCondition.
//
//   battery > 20 && !charging
//   attempts += 1; state := attempts < 3 ? 'again' : 'give up'
//
// A script is compiled once, when its tree is loaded, to typed code on blackboard slots; running it
// looks up no name and allocates nothing unless it makes a new long string. The language is that of
// BehaviorTree.CPP 4; docs/scripts.md describes it.
#ifndef COPPICE_BT_CORE_SCRIPT_SCRIPT_H_
#define COPPICE_BT_CORE_SCRIPT_SCRIPT_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt_core/data/blackboard.h"

namespace coppice {

/// A name in scripts that stands for a number, such as the enumerators of a registered enum.
struct ScriptConstants : std::map<std::string, std::int64_t, std::less<>> {
  using Map = std::map<std::string, std::int64_t, std::less<>>;
  using Map::Map;
  bool are_real = false;  ///< the numbers are of type double, as in BehaviorTree.CPP
};

/// Adds the names of an enum. Returns the first that stands for another number already, if any.
std::optional<std::string> AddEnumerators(const EnumeratorList& list, ScriptConstants& constants);

/// What the names in a script mean in one place of a tree.
class ScriptNames {
 public:
  virtual ~ScriptNames() = default;
  /// The slot of a name ("key", or "@key" for a key of the main tree); made if nobody used it yet.
  virtual SlotIndex Slot(std::string_view name) = 0;
  /// The type that ports give to a slot; null if no port does, then it takes values of any type.
  virtual const Type* TypeOf(SlotIndex slot) const = 0;
  /// True if `=` may give the slot its first value, as `:=` may.
  virtual bool IsDeclared(SlotIndex) const { return false; }
  /// True if a port or another script has this key already. Asked for constants: a name that is
  /// both is a problem.
  virtual bool IsKey(std::string_view name) const = 0;
};

/// What is wrong with a script, and where in its text.
struct ScriptProblem {
  std::size_t offset;  ///< in bytes from the start of the script
  std::string message;
  std::string hint;         ///< may be empty
  bool is_warning = false;  ///< it can run all the same
};

/// What a script is there for.
enum class ScriptUse : std::uint8_t {
  kAction,     ///< for what it does
  kCondition,  ///< for its truth: an assignment taken for true or false is a warning
};

namespace script {
struct Code;
struct Instruction;
}  // namespace script

/// While running: an operand has no value, or values of types that the operator does not take.
struct ScriptError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Stands for the type of a port whose text is a script. No slot has this type.
struct ScriptCode {};

/// A compiled script. Immutable and cheap to copy; any number of threads may run it, each on a
/// blackboard of its own.
class Script {
 public:
  /// At most so many bytes of text.
  static constexpr std::size_t kMaxSize = 65536;

  /// Nothing is returned if there are problems other than warnings; all of them are in `problems`.
  static std::optional<Script> Compile(std::string_view text, ScriptNames& names,
                                       const ScriptConstants& constants,
                                       std::vector<ScriptProblem>& problems,
                                       ScriptUse use = ScriptUse::kAction);

  /// Runs all statements. Throws ScriptError; what was assigned before stays assigned.
  void Run(Blackboard& blackboard) const;

  /// Runs all statements; true if the value of the last is true, a number other than 0, or a text
  /// that reads as one of these. Throws ScriptError, also if it is neither true nor false.
  bool Test(Blackboard& blackboard) const;

  /// The slots that the script may read or write, in ascending order. `x += 1` does both.
  const std::vector<SlotIndex>& reads() const;
  const std::vector<SlotIndex>& writes() const;

 private:
  explicit Script(std::shared_ptr<const script::Code> code);

  std::shared_ptr<const script::Code> code_;
  const script::Instruction* test_;  // where Test begins
};

template <>
struct ValueTraits<ScriptCode> {
  static constexpr const char* kName = "script";
  static bool Parse(std::string_view, ScriptCode&) { return true; }
  static std::string Print(const ScriptCode&) { return {}; }
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_SCRIPT_SCRIPT_H_
