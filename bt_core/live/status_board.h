// The latest status of every node, written by the ticking thread and read by another one.
//
// A sequence lock: the writer never waits, and writing a change costs a store. The reader tries
// again when a write came between. Source: Boehm, "Can Seqlocks Get Along With Programming Language
// Memory Models?", MSPC 2012.
#ifndef COPPICE_BT_CORE_LIVE_STATUS_BOARD_H_
#define COPPICE_BT_CORE_LIVE_STATUS_BOARD_H_

#include <atomic>
#include <cstdint>
#include <vector>

#include "bt_core/engine/events.h"

namespace coppice {

class StatusBoard {
 public:
  explicit StatusBoard(const std::vector<Status>& statuses);

  /// One writing thread. Neither allocates nor waits.
  void Apply(const std::vector<StatusChange>& changes);

  /// Any thread: one byte per node. A node that is active or has completed shows its status; one
  /// that was reset shows 10 + the status it had before; one that never ran shows 0. All bytes are
  /// of the same tick, unless the writer does nothing but write for a whole second.
  void Read(std::vector<std::uint8_t>& out) const;

 private:
  bool TryRead(std::vector<std::uint8_t>& out) const;

  std::vector<std::atomic<std::uint8_t>> bytes_;
  std::atomic<std::uint32_t> version_{0};  // odd while Apply works
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_STATUS_BOARD_H_
