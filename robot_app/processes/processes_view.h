// What /processes says, for people (a table) and for programs (JSON).
#ifndef COPPICE_ROBOT_APP_PROCESSES_PROCESSES_VIEW_H_
#define COPPICE_ROBOT_APP_PROCESSES_PROCESSES_VIEW_H_

#include <coppice_msgs/ProcessStates.h>

#include <string>

#include "bt_core/base/clock.h"

namespace coppice::robot::processes {

/// One line per process under a head line and a line about the configuration. `now`: wall time.
std::string ToTable(const coppice_msgs::ProcessStates& states, Time now);

/// One object with the fields of the message; times in seconds since 1970, 0 for none; states and
/// steps by name.
std::string ToJson(const coppice_msgs::ProcessStates& states);

/// The processes alone, as a list on one line: what an editor shows as a table.
std::string ToJsonRows(const coppice_msgs::ProcessStates& states);

/// Every process of the configuration is ready or done: nothing changes, waits, backs off or was
/// given up.
bool IsAsItShouldBe(const coppice_msgs::ProcessStates& states);

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_PROCESSES_VIEW_H_
