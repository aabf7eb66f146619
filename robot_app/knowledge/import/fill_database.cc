#include "robot_app/knowledge/import/fill_database.h"

#include "robot_app/common/shipped.h"
#include "robot_app/knowledge/import/read_campus.h"
#include "robot_app/knowledge/store/queries.h"
#include "robot_app/knowledge/store/write_campus.h"

namespace coppice::robot::knowledge {

Expected<Database> OpenFilled(const std::string& path, const std::string& site) {
  auto database = Database::OpenOrCopy(path);
  if (!database || site.empty() || FindSite(*database)) return database;
  Diagnostics diagnostics;
  const Campus campus =
      ReadCampus(site == "sample" ? Shipped(COPPICE_SAMPLE_FOLDER) : site, diagnostics);
  if (diagnostics.has_errors()) return Problem{diagnostics.ToString()};
  const Outcome written = WriteCampus(*database, campus);
  if (!written) return Problem{written.problem()};
  return database;
}

}  // namespace coppice::robot::knowledge
