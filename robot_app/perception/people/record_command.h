// coppice-people --offline FILE: who was there in a record, as a table and as pictures.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_RECORD_COMMAND_H_
#define COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_RECORD_COMMAND_H_

#include <string>
#include <vector>

namespace coppice::robot::perception {

/// Whether the arguments ask for it.
bool IsAboutRecord(const std::vector<std::string>& arguments);

/// Returns the exit status. The files of `coppice-train people` and `legs` are used unless the
/// arguments name others.
int LookIntoRecord(const std::vector<std::string>& arguments, const std::string& clouds_file,
                   const std::string& legs_file);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_RECORD_COMMAND_H_
