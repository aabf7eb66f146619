// The ROS master of this process, asked with a deadline: ros::master::check waits for ever if the
// master hangs. For any thread, after ros::init.
#ifndef COPPICE_ROBOT_APP_COMMON_FIND_MASTER_H_
#define COPPICE_ROBOT_APP_COMMON_FIND_MASTER_H_

#include <string>

namespace coppice::robot {

/// True if the master at ROS_MASTER_URI answers within 2 s. Silences the library of XML-RPC.
bool HasMaster();

/// The same, and if there is none it says "PROGRAM: no ROS master at URI (ROS_MASTER_URI)".
bool FindMaster(const std::string& program);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_FIND_MASTER_H_
