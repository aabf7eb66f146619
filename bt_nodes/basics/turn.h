// Whose action a robot carries out: of all leaves that began one of the same kind the last one. A
// reactive node begins a more urgent branch before it halts the one that ran, so a leaf may be
// halted when another has taken its place already; it must not cancel what that one has begun.
//
// Any thread: several trees act on one robot.
#ifndef COPPICE_BT_NODES_BASICS_TURN_H_
#define COPPICE_BT_NODES_BASICS_TURN_H_

#include <atomic>
#include <cstdint>

namespace coppice::leaves {

class Turn {
 public:
  /// A leaf begins an action. Returns its number.
  std::uint64_t Begin() { return ++newest_; }
  bool IsNewest(std::uint64_t number) const { return newest_ == number; }

 private:
  std::atomic<std::uint64_t> newest_{0};
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_BASICS_TURN_H_
