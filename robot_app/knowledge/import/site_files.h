// places.yaml, campus.yaml, staff.csv and small_talk.yaml: what people of the site write
// (docs/service.md).
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_SITE_FILES_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_SITE_FILES_H_

#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/knowledge/import/named.h"

namespace coppice::robot::knowledge {

/// A place that stands for stops of a timetable.
struct StopOfPlace {
  LocatedText stop;
  std::string place;
};

/// What other files refer to.
struct SiteIds {
  Ids places{"place"};
  Ids diets{"diet"};
  std::vector<StopOfPlace> stops;
};

/// places.yaml, the robot's topological map, and campus.yaml, what only people want to know of it.
void ReadPlaces(const std::string& folder, Campus& campus, SiteIds& ids, Diagnostics& diagnostics);
void ReadStaff(const std::string& path, Campus& campus, SiteIds& ids, Diagnostics& diagnostics);
void ReadSmallTalk(const std::string& path, Campus& campus, Diagnostics& diagnostics);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_SITE_FILES_H_
