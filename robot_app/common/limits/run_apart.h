// Does something with a file of somebody else that may end the program that does it: libraries that
// read records and networks crash at some of them. It is done in a copy of this process, so that
// only the copy ends.
//
//   const Expected<int> tried = RunApart([&] { return TryNetwork(file); }, {});
//   if (!tried) return Problem{file + ": OpenCV " + tried.problem()};
//
// The copy has none of the other threads: what is run may not wait for one.
#ifndef COPPICE_ROBOT_APP_COMMON_LIMITS_RUN_APART_H_
#define COPPICE_ROBOT_APP_COMMON_LIMITS_RUN_APART_H_

#include <chrono>
#include <cstddef>
#include <functional>

#include "bt_core/base/outcome.h"

namespace coppice::robot {

struct ApartLimits {
  std::size_t memory = 0;            ///< bytes of data, with what there is already; 0: any
  std::chrono::seconds patience{0};  ///< 0: any time
};

/// What `run` returns, 0 to 255, or a problem: "crashed (signal 11)", "took longer than 60 s". What
/// it throws ends the copy like a crash. Waits until it has ended.
Expected<int> RunApart(const std::function<int()>& run, const ApartLimits& limits);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_LIMITS_RUN_APART_H_
