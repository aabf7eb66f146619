// No vector or text of a robot's program is larger than this: what is asked for beyond is denied
// (std::bad_alloc). Whoever links robot_common has it; there is nothing to call. LimitMemory is for
// all of a program's data.
//
// A message of ROS says how long its arrays are, and roscpp makes room for them before it looks
// whether they are there. So 70 bytes with a wrong length take gigabytes in every program that
// listens; with the limit it is a message that cannot be read, as any other damaged one.
//
// Arrays (new T[n]) have no such limit: roscpp's buffers are some. They take memory as it arrives.
#ifndef COPPICE_ROBOT_APP_COMMON_LIMITS_LARGEST_ALLOCATION_H_
#define COPPICE_ROBOT_APP_COMMON_LIMITS_LARGEST_ALLOCATION_H_

#include <cstddef>

namespace coppice::robot {

inline constexpr std::size_t kLargestAllocation = std::size_t{128} << 20;  ///< bytes

/// From now on this program has no more than so many bytes for its data, with what it has already:
/// std::bad_alloc. For a program that reads files of others beside a robot that drives.
void LimitMemory(std::size_t bytes);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_LIMITS_LARGEST_ALLOCATION_H_
