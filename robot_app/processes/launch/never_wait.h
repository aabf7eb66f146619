// Whoever watches over others must not wait for those who read what it says: a pager that nobody
// scrolls, a terminal that was stopped (Ctrl-S), a connection that hangs.
#ifndef COPPICE_ROBOT_APP_PROCESSES_LAUNCH_NEVER_WAIT_H_
#define COPPICE_ROBOT_APP_PROCESSES_LAUNCH_NEVER_WAIT_H_

namespace coppice::robot::processes {

/// From now on what would have to wait for the reader of standard output or error is lost. So it is
/// for programs that inherit them. Others who have the same terminal or pipe, such as the shell,
/// notice nothing. Before other threads begin.
void NeverWaitForReaders();

/// What was lost does not silence std::cout and std::cerr for what comes later. Now and then.
void GoOnAfterLoss();

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_LAUNCH_NEVER_WAIT_H_
