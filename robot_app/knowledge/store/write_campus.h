// What an import leaves in the database.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_STORE_WRITE_CAMPUS_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_STORE_WRITE_CAMPUS_H_

#include "bt_core/base/outcome.h"
#include "robot_app/knowledge/store/database.h"
#include "robot_app/knowledge/store/records.h"

namespace coppice::robot::knowledge {

/// Replaces all that an import has written before, in one transaction: after a problem, or when the
/// program is killed, the old knowledge is there as it was.
Outcome WriteCampus(Database& database, const Campus& campus);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_STORE_WRITE_CAMPUS_H_
