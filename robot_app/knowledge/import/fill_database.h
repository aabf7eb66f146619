// The start of a robot that was never told about its site.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_FILL_DATABASE_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_FILL_DATABASE_H_

#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/knowledge/store/database.h"

namespace coppice::robot::knowledge {

/// Makes the database `path`, if it is not there, and imports the files of the folder `site` into
/// one that knows of no site; "sample" is the invented campus, empty: imports nothing. Several
/// programs may do so at once. Where the disk takes nothing it is a copy (Database::OpenOrCopy). A
/// problem tells all that is wrong with the files.
Expected<Database> OpenFilled(const std::string& path, const std::string& site);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_FILL_DATABASE_H_
