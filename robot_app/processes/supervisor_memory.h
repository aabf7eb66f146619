// What a process supervisor leaves to the one after it, in a file: otherwise a supervisor that
// crashes in a loop, or restarts the whole stack, would reset its own limits.
//
// The file is JSON with a version, for its owner alone, and replaced as a whole (WriteFile). One
// that is damaged or of another version counts as empty, with a warning: a robot must be able to
// start.
#ifndef COPPICE_ROBOT_APP_PROCESSES_SUPERVISOR_MEMORY_H_
#define COPPICE_ROBOT_APP_PROCESSES_SUPERVISOR_MEMORY_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/processes/escalation.h"

namespace coppice::robot::processes {

/// By name, because the configuration file may have changed in between. Times are nanoseconds since
/// 1970.
struct SupervisorMemory {
  std::string site;           ///< where the robot is; empty: as the file says
  std::string configuration;  ///< empty: as the file says
  bool manual = false;
  bool safe_stop = false;
  bool new_stack = false;    ///< the whole stack was on its way to be restarted ...
  bool clear_stack = false;  ///< ... from a cleared state
  std::map<std::string, GroupMemory> groups;
  std::map<std::string, std::uint32_t> restarts;  ///< ever, by process
  std::vector<Time> stack_restarts;
  std::size_t stack_counting = 0;
};

std::string ToText(const SupervisorMemory& memory);

/// Of a text that ToText has made. Times after `now` count as now: the computer's clock may have
/// been set back.
Expected<SupervisorMemory> MemoryFromText(const std::string& text, Time now);

/// A file that is missing is no problem: an empty memory.
Expected<SupervisorMemory> LoadMemory(const std::string& path, Time now);

/// If it cannot be written, the old file is as it was.
Outcome SaveMemory(const SupervisorMemory& memory, const std::string& path);
/// The same; a problem is a line on stderr.
void KeepMemory(const SupervisorMemory& memory, const std::string& path);

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_SUPERVISOR_MEMORY_H_
