// One message to the supervisors without a running robot: for the process supervisor, when it has
// given up and nothing else may be left.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_CALL_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_CALL_H_

#include <string>

#include "robot_app/assistance/assistance.h"

namespace coppice::robot::assistance {

/// Tries the supervisors in their order, each by all ways, until a message has gone out. False,
/// with all that went wrong in `problems`, if none did. Blocks.
bool CallSupervisors(const AssistanceConfig& config, Channels channels, const std::string& subject,
                     const std::string& text, std::string& problems);

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_CALL_H_
