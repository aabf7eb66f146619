// The sample campus in a database of a test's own.
#ifndef COPPICE_TESTS_ROBOT_APP_KNOWLEDGE_SAMPLE_DATABASE_H_
#define COPPICE_TESTS_ROBOT_APP_KNOWLEDGE_SAMPLE_DATABASE_H_

#include <stdexcept>
#include <string>

#include "robot_app/knowledge/import/read_campus.h"
#include "robot_app/knowledge/store/queries.h"
#include "robot_app/knowledge/store/write_campus.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::knowledge {

inline std::string SampleFolder() { return SourceFolder() + "/robot_app/knowledge/sample"; }

inline Campus SampleCampus() {
  Diagnostics diagnostics;
  Campus campus = ReadCampus(SampleFolder(), diagnostics);
  if (!diagnostics.all().empty()) throw std::runtime_error(diagnostics.ToString());
  return campus;
}

class SampleDatabase {
 public:
  SampleDatabase() : database_(Database::OpenOrCreate(path()).value()) {
    static const Campus campus = SampleCampus();
    const Outcome written = WriteCampus(database_, campus);
    if (!written) throw std::runtime_error(written.problem());
  }
  std::string path() const { return folder_.Path("campus.db"); }
  Database& operator*() { return database_; }

  SiteTime time() const { return SiteTime::Find("Europe/Berlin").value(); }
  /// A moment of the site: Wednesday is 2026-11-25.
  WallTime At(const std::string& day, int hour, int minute = 0) const {
    return time().OfTimetable(*ParseDay(day),
                              std::chrono::hours(hour) + std::chrono::minutes(minute));
  }

 private:
  TemporaryFolder folder_;
  Database database_;
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_TESTS_ROBOT_APP_KNOWLEDGE_SAMPLE_DATABASE_H_
