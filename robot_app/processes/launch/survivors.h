// Processes that have outlived who started them: found by a variable of their environment, which
// they inherit however often they fork and whatever session they make.
#ifndef COPPICE_ROBOT_APP_PROCESSES_LAUNCH_SURVIVORS_H_
#define COPPICE_ROBOT_APP_PROCESSES_LAUNCH_SURVIVORS_H_

#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/outcome.h"

namespace coppice::robot::processes {

inline constexpr char kOwnerVariable[] = "COPPICE_SUPERVISED";

/// Value of the variable for one process of an owner.
std::string OwnedName(const std::string& owner, const std::string& process);

/// Makes this process the only one that may end what the owner has left behind, until it ends or
/// becomes another program; `file` stays. 0, or the process that is it already (-1 if it has not
/// said its number): one that was killed may not be gone yet, so it is asked until the deadline.
Expected<int> BecomeOnlyOne(const std::string& file, Duration deadline);

/// Living processes of this computer whose variable begins with this: an owner, or an OwnedName.
/// Not this one, and only those that may be looked into.
std::vector<int> FindOwned(const std::string& owned);

/// Kills them (SIGKILL) and waits until they are gone. Returns how many there were, or -1 if some
/// are still there after the deadline.
int KillOwned(const std::string& owned, Duration deadline);

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_LAUNCH_SURVIVORS_H_
