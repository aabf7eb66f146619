// stop_times.txt and frequencies.txt of a GTFS feed: by far the largest table, of which the trips
// are kept that call at a stop of the site.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_STOP_TIMES_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_STOP_TIMES_H_

#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/knowledge/import/zip_archive.h"
#include "robot_app/knowledge/store/records.h"

namespace coppice::robot::knowledge {

class StopTimes {
 public:
  /// More calls at the site's stops, with the others of their trips, are refused.
  static constexpr std::size_t kMostCalls = 5'000'000;

  /// `stops` and `all_trips` by their ids in the feed; all must outlive this.
  StopTimes(const ZipArchive& archive, const std::unordered_map<std::string, std::string>& stops,
            const std::map<std::string, std::string>& boarding,
            const std::unordered_map<std::string, Trip>& all_trips, Diagnostics& diagnostics)
      : archive_(archive),
        stops_(stops),
        boarding_(boarding),
        all_trips_(all_trips),
        diagnostics_(diagnostics) {}

  void Read();

  std::vector<Trip> trips;  ///< each with a headsign
  std::vector<Call>
      calls;  ///< of these, trip by trip, in order; times between timepoints filled in

 private:
  struct Frequency {
    std::chrono::seconds first{0}, end{0}, headway{0};
  };

  void FindTrips();
  void ReadCalls();
  void ReadCall(const CsvRow& row);
  void ReadFrequencies();
  void AddTrip(const std::string& id, std::vector<Call>& of_trip);
  void ReportTooMany();
  void Repeat(const Trip& trip, const std::vector<Call>& of_trip, const Frequency& frequency);

  const ZipArchive& archive_;
  const std::unordered_map<std::string, std::string>& stops_;
  const std::map<std::string, std::string>& boarding_;
  const std::unordered_map<std::string, Trip>& all_trips_;
  Diagnostics& diagnostics_;
  std::unordered_set<std::string> wanted_;            // trips, by the feed's id
  std::map<std::string, std::vector<Call>> by_trip_;  // likewise
  std::map<std::string, std::vector<Frequency>> frequencies_;
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_STOP_TIMES_H_
