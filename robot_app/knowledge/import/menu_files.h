// menus/: what canteens offer, as OpenMensa publishes it.
//
// menus/CANTEEN.LANGUAGE.json is an answer to GET /api/v2/canteens/ID/meals (docs.openmensa.org):
// a list of days with meals. CANTEEN is the id of a place. menus/diets.yaml tells which notes make
// a meal vegetarian or vegan.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_MENU_FILES_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_MENU_FILES_H_

#include <string>

#include "robot_app/knowledge/import/site_files.h"

namespace coppice::robot::knowledge {

void ReadMenus(const std::string& folder, Campus& campus, SiteIds& ids, Diagnostics& diagnostics);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_MENU_FILES_H_
