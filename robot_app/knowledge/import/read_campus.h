// All that people and other services say about the site, from one folder:
//
//   places.yaml            places and what they are called (robot_app/common/places/)
//   campus.yaml            time zone, buildings, categories, opening hours, stops
//   staff.csv              people and their offices
//   small_talk.yaml        what is said to the robot, and what it answers
//   menus/*.json           canteens, as OpenMensa publishes them; menus/diets.yaml
//   transport/*.zip        timetables, GTFS
//
// All but the first two may be missing. docs/service.md describes them.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_READ_CAMPUS_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_READ_CAMPUS_H_

#include <string>

#include "bt_core/base/diagnostic.h"
#include "robot_app/knowledge/store/records.h"

namespace coppice::robot::knowledge {

/// Everything that is wrong in any of the files is reported; with errors the result is not to be
/// used.
Campus ReadCampus(const std::string& folder, Diagnostics& diagnostics);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_READ_CAMPUS_H_
