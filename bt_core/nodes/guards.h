// Guards and hooks: the scripts that any node may carry as attributes.
//
// Before a node that is not RUNNING is ticked, its guards are asked in the order of the list below;
// the first that decides gives the node's result without a tick. `_while` is asked in every tick,
// also while the node is RUNNING, and halts it. Each hook runs at most once in an activation.
#ifndef COPPICE_BT_CORE_NODES_GUARDS_H_
#define COPPICE_BT_CORE_NODES_GUARDS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace coppice {

enum class Guard : std::uint8_t {
  kFailureIf,  ///< true: FAILURE
  kSuccessIf,  ///< true: SUCCESS
  kSkipIf,     ///< true: SKIPPED
  kOnlyIf,     ///< false: SKIPPED
  kWhile,      ///< false: halts what the node has begun; SKIPPED
  kOnStart,    ///< before the first tick of an activation, unless it goes on after SKIPPED
  kOnSuccess,
  kOnFailure,
  kPost,      ///< after SUCCESS or FAILURE, behind the hook of that result
  kOnHalted,  ///< after a node was halted that was RUNNING or kept something while SKIPPED
};
inline constexpr std::size_t kGuardCount = 10;

/// In the order of Guard.
inline constexpr std::array<std::string_view, kGuardCount> kGuardAttributes = {
    "_failureIf", "_successIf", "_skipIf",    "_onlyIf", "_while",
    "_onStart",   "_onSuccess", "_onFailure", "_post",   "_onHalted"};

/// True for the attributes whose value is a script: guards and hooks.
constexpr bool IsGuardAttribute(std::string_view name) {
  for (const std::string_view guard : kGuardAttributes) {
    if (guard == name) return true;
  }
  return false;
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_GUARDS_H_
