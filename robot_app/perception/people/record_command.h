// coppice-people --offline FILE: who was there in a record, as a table and as pictures.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_RECORD_COMMAND_H_
#define COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_RECORD_COMMAND_H_

#include <string>
#include <vector>

namespace coppice::robot::perception {

/// Whether the arguments ask for it.
bool IsAboutRecord(const std::vector<std::string>& arguments);

/// Returns the exit status. `classifier_file` is used unless the arguments name another.
int LookIntoRecord(const std::vector<std::string>& arguments, const std::string& classifier_file);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_RECORD_COMMAND_H_
