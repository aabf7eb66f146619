// What a node does by chance: in every activation it is RUNNING for a while and then returns one of
// its results. The same seed gives the same behaviour, on every computer.
//
//   Dice dice(seed, "patrol/drive");        // each node has its own
//   const DrawnResult drawn = Throw(chances, dice);
#ifndef COPPICE_BT_CORE_TESTING_CHANCES_H_
#define COPPICE_BT_CORE_TESTING_CHANCES_H_

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/status.h"

namespace coppice {

/// Of the results only the proportions count; if all are 0 it succeeds.
struct Chances {
  double success = 0;
  double failure = 0;
  double skipped = 0;    ///< a node that skips does so at once
  Duration shortest{0};  ///< RUNNING for so long before SUCCESS or FAILURE, any time up to
  Duration longest{0};
  Duration shortest_hold{0};  ///< it does the same again for so long, any time up to
  Duration longest_hold{0};
};

/// Random numbers: SplitMix64 (Steele, Lea and Flood: Fast splittable pseudorandom number
/// generators, 2014).
class Dice {
 public:
  Dice() = default;
  /// `who` keeps nodes apart that have the same seed.
  Dice(std::uint64_t seed, std::string_view who);
  /// At least 0, less than 1.
  double Next();

 private:
  std::uint64_t state_ = 0;
};

struct DrawnResult {
  Duration after{0};  ///< in which it is RUNNING
  Status result = Status::kSuccess;
  Duration holds{0};  ///< in which it does the same again
};

/// Takes two numbers of the dice, and a third if the outcome holds for some time.
DrawnResult Throw(const Chances& chances, Dice& dice);

/// One element of a list that is not empty, each as probable as the others; takes one number.
template <class T>
const T& ChooseOne(const std::vector<T>& list, Dice& dice) {
  return list[static_cast<std::size_t>(dice.Next() * static_cast<double>(list.size()))];
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_CHANCES_H_
