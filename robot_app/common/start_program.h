// Starts a program of the operating system.
#ifndef COPPICE_ROBOT_APP_COMMON_START_PROGRAM_H_
#define COPPICE_ROBOT_APP_COMMON_START_PROGRAM_H_

#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/outcome.h"

namespace coppice::robot {

/// What a program is started with. The files stay the caller's.
struct ProgramStart {
  std::vector<std::string> command;  ///< program (looked up in PATH) and arguments
  /// Set on top of our own environment.
  std::vector<std::pair<std::string, std::string>> environment;
  int input = -1;   ///< file for standard input; negative: none
  int output = -1;  ///< file for standard output and error
};

/// As the leader of a process group of its own, with none of our open files and signals as they are
/// by default. It gets SIGTERM when the thread that has started it ends. Returns its pid.
Expected<int> StartProgram(const ProgramStart& start);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_START_PROGRAM_H_
