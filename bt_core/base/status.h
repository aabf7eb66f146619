// The result of a tick, and what a node remembers of it.
//
// A node returns kRunning, kSuccess, kFailure or kSkipped; it never returns kIdle, which is the
// state of a node that is not active. The numbers are those of the Groot2 protocol.
#ifndef COPPICE_BT_CORE_BASE_STATUS_H_
#define COPPICE_BT_CORE_BASE_STATUS_H_

#include <cstdint>

namespace coppice {

enum class Status : std::uint8_t {
  kIdle = 0,
  kRunning = 1,
  kSuccess = 2,
  kFailure = 3,
  kSkipped = 4,  ///< the node had nothing to do; its parent goes on as if it were not there
};

/// True for kSuccess and kFailure.
constexpr bool IsCompleted(Status status) {
  return status == Status::kSuccess || status == Status::kFailure;
}

/// "IDLE", "RUNNING", "SUCCESS", "FAILURE" or "SKIPPED".
const char* ToString(Status status);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_STATUS_H_
