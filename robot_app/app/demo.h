// The demonstration: the whole robot for some patrol rounds. A node is killed and a corridor
// blocked on the way; the monitor tree must recover from both.
#ifndef COPPICE_ROBOT_APP_APP_DEMO_H_
#define COPPICE_ROBOT_APP_APP_DEMO_H_

#include "robot_app/app/demo_settings.h"

namespace coppice::robot {

/// Runs it and prints a summary. Returns the exit status: 0 only if everything went well and no
/// process is left. Calls ros::init, so once in a process. `interrupted` may be set by a signal
/// handler; then it ends soon.
int RunDemo(const DemoSettings& settings, const volatile int& interrupted);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_APP_DEMO_H_
