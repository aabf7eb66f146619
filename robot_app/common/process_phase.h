// In which phase of its life the process supervisor sees a process.
#ifndef COPPICE_ROBOT_APP_COMMON_PROCESS_PHASE_H_
#define COPPICE_ROBOT_APP_COMMON_PROCESS_PHASE_H_

#include <cstdint>

namespace coppice::robot {

/// The numbers are those of coppice_msgs/ProcessState.
enum class ProcessPhase : std::uint8_t {
  kStopped = 0,
  kStarting = 1,  ///< waits for its dependencies, is started but not ready, or ends for a restart
  kReady = 2,
  kBackingOff = 3,
  kGivenUp = 4,
  kUnreachable = 5,  ///< its host does not answer
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_PROCESS_PHASE_H_
