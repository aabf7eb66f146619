#include "robot_app/knowledge/import/fill_database.h"

#include "robot_app/common/shipped.h"
#include "robot_app/knowledge/import/read_campus.h"
#include "robot_app/knowledge/store/queries.h"
#include "robot_app/knowledge/store/write_campus.h"

namespace coppice::robot::knowledge {

Outcome FillIfEmpty(const std::string& path, const std::string& site) {
  auto database = Database::OpenOrCreate(path);
  if (!database) return Problem{database.problem()};
  if (site.empty() || FindSite(*database)) return {};
  Diagnostics diagnostics;
  const Campus campus =
      ReadCampus(site == "sample" ? Shipped(COPPICE_SAMPLE_FOLDER) : site, diagnostics);
  if (diagnostics.has_errors()) return Problem{diagnostics.ToString()};
  return WriteCampus(*database, campus);
}

}  // namespace coppice::robot::knowledge
