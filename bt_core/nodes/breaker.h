// CircuitBreaker: stops trying what keeps failing.
//
//   state        child SUCCESS        child FAILURE                        RUNNING    SKIPPED
//   closed       SUCCESS              FAILURE; opens if there were         RUNNING    SKIPPED
//                                     `max_failures` in `period_msec`
//   open         the child is not ticked: the port `if_open`, for `open_msec`; then half open
//   half open    SUCCESS; closes      FAILURE; opens again                 RUNNING    SKIPPED
//
// A halt changes nothing. What resets the failures: opening, and age. Sources: Nygard, "Release
// It!", 2007, for the three states; Erlang/OTP's supervisor for "so many in so long".
#ifndef COPPICE_BT_CORE_NODES_BREAKER_H_
#define COPPICE_BT_CORE_NODES_BREAKER_H_

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/data/value.h"
#include "bt_core/nodes/rate.h"

namespace coppice {

/// When the last failures were, the oldest first.
class FailureTimes {
 public:
  /// Adds a failure and forgets those before `oldest`. Returns how many there are.
  std::size_t Add(Time now, Time oldest);
  void Clear() { times_.clear(); }

  friend struct ValueTraits<FailureTimes>;

 private:
  std::vector<std::int64_t> times_;
};

template <>
struct ValueTraits<FailureTimes> {
  static constexpr const char* kName = "times";
  static bool Parse(std::string_view text, FailureTimes& out);  // "1000;2500", in nanoseconds
  static std::string Print(const FailureTimes& value);
};

/// Own slot 0: the failures. Own slot 1: the time until which it is open, plus 1; 0 when closed.
template <class Tree>
Status TickCircuitBreaker(Tree& tree, NodeIndex node) {
  using std::chrono::milliseconds;
  auto& failures = tree.template Own<FailureTimes>(node, 4);
  std::uint64_t& open_until = tree.template Own<std::uint64_t>(node, 5);
  const Time until = TimeFromNanoseconds(static_cast<std::int64_t>(open_until) - 1);
  const bool child_runs = tree.status(node + 1) == Status::kRunning;
  if (open_until != 0 && !child_runs && tree.now() < until) {
    return internal::HeldBack(tree, until, internal::ResultPort(tree, node, 3));
  }
  const Status result = tree.Tick(node + 1);
  if (result == Status::kRunning) return result;
  if (result == Status::kSuccess) open_until = 0;
  if (result == Status::kFailure) {
    const milliseconds period(tree.template Port<unsigned>(node, 1));
    const std::size_t count = failures.Add(tree.now(), tree.now() - period);
    if (open_until != 0 || count >= tree.template Port<unsigned>(node, 0)) {
      const milliseconds open_for(tree.template Port<unsigned>(node, 2));
      open_until = static_cast<std::uint64_t>(ToNanoseconds(tree.now() + open_for)) + 1;
      failures.Clear();
    }
  }
  return internal::PassOn(tree, node, result);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_BREAKER_H_
