// How fast a simulator goes beside the programs that a test looks at.
#ifndef COPPICE_TESTS_ROBOT_APP_SIMULATION_SPEED_H_
#define COPPICE_TESTS_ROBOT_APP_SIMULATION_SPEED_H_

#include <string>

namespace coppice::robot {

/// The simulator's argument for so many times real time; at least real time. A robot that
/// ThreadSanitizer watches thinks ten times slower: it gets a third of it, so that it is not called
/// late for that.
inline std::string SimulationSpeed(int times) {
#ifdef __SANITIZE_THREAD__
  times = times < 3 ? 1 : times / 3;
#endif
  return "_speed:=" + std::to_string(times);
}

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_ROBOT_APP_SIMULATION_SPEED_H_
