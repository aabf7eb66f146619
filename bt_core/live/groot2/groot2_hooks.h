// Hooks and breakpoints as the Groot2 protocol has them: JSON of its clients, translated for the
// Debugger. At most one hook for each node and position; they belong to nobody in particular.
#ifndef COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_HOOKS_H_
#define COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_HOOKS_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "bt_core/live/debug/debugger.h"

namespace coppice {

class Groot2Hooks {
 public:
  Groot2Hooks(Debugger& debugger, OwnerId owner) : debugger_(debugger), owner_(owner) {}

  // Problems are worded as in the protocol. Malformed JSON throws std::exception with the text that
  // the protocol answers.

  /// An object or an array of objects. A node that there is not, of `nodes`, is passed over.
  Outcome Insert(std::string_view json, std::size_t nodes);
  Outcome Remove(std::string_view json);
  Outcome Unlock(std::string_view json);
  /// A JSON array.
  std::string Dump();

  void RemoveAll();
  void SetAllEnabled(bool enabled);
  bool empty() const { return hooks_.empty(); }

  /// The number of the node to publish when the debugger tells of this hook; nothing if it is none
  /// of these.
  std::optional<std::uint16_t> UidOf(HookId id) const;

 private:
  enum class Mode : std::uint8_t { kBreakpoint = 0, kReplace = 1 };
  struct Groot2Hook {
    std::uint16_t uid = 0;
    HookPosition position = HookPosition::kBefore;
    Mode mode = Mode::kBreakpoint;
    bool once = false;
    bool enabled = true;
    std::string desired_status;
    HookId id = kNoHook;
  };
  using Place = std::pair<std::uint16_t, HookPosition>;

  static Hook Translate(const Groot2Hook& hook);
  Outcome InsertOne(Groot2Hook hook);
  void ForgetFinished();

  Debugger& debugger_;
  const OwnerId owner_;
  std::map<Place, Groot2Hook> hooks_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_HOOKS_H_
