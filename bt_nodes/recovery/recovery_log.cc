#include "bt_nodes/recovery/recovery_log.h"

#include <array>
#include <cstddef>

namespace coppice::leaves {

const char* ToString(RecoveryPhase phase) {
  constexpr std::array<const char*, 5> kNames = {"begun", "succeeded", "failed", "interrupted",
                                                 "refused"};
  return kNames[static_cast<std::size_t>(phase)];
}

}  // namespace coppice::leaves
