// OpenCV crashes at some of the files that it is given, or never gets done with them. So what uses
// one is tried in a copy of the program, before the program itself does.
//
//   const Expected<int> tried = TryApart([&] { return Load(file) ? 0 : 1; });
//   if (!tried) return Problem{file + ": OpenCV " + tried.problem()};   // "crashed (signal 11)"
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_TRY_APART_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_TRY_APART_H_

#include <chrono>
#include <functional>
#include <opencv2/core/utility.hpp>

#include "robot_app/common/limits/run_apart.h"

namespace coppice::robot::perception {

/// As RunApart, with 2 GiB of memory and a minute.
inline Expected<int> TryApart(const std::function<int()>& use) {
  constexpr ApartLimits kTrial{std::size_t{2} << 30, std::chrono::seconds(60)};
  return RunApart(
      [&use] {
        cv::setNumThreads(1);  // the copy has no others
        return use();
      },
      kTrial);
}

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_TRY_APART_H_
