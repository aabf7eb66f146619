// What can be asked of the knowledge. The clock is handed in: a query reads no time by itself. All
// throw std::runtime_error if the file is damaged; questions that belong together are asked within
// one Snapshot (database.h).
//
//   const Expected<SiteTime> time = TimeOf(database);
//   for (const Departure& next : NextDepartures(database, *time, now, {"4", "", ""}, 3)) ...
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_STORE_QUERIES_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_STORE_QUERIES_H_

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/knowledge/store/database.h"
#include "robot_app/knowledge/store/records.h"

namespace coppice::robot::knowledge {

/// The site without its holidays; nothing before the first import.
std::optional<Site> FindSite(const Database& database);
Expected<SiteTime> TimeOf(const Database& database);
bool IsHoliday(const Database& database, Day day);

/// All names of all subjects, those that the operator has added too.
std::vector<Name> Names(const Database& database);
/// What the robot calls it, in that language if it can; the subject if it has no name.
std::string NameOf(const Database& database, Kind kind, const std::string& subject,
                   Language language);
std::string BuildingName(const Database& database, const std::string& building, Language language);

std::optional<Place> FindPlace(const Database& database, const std::string& id);
/// In the order of the file.
std::vector<Place> PlacesOf(const Database& database, const std::string& category);
std::optional<Person> FindPerson(const Database& database, const std::string& id);
/// Who sits there.
std::vector<Person> PeopleIn(const Database& database, const std::string& place);

/// How far it is to a place, in any unit; infinite if there is no way.
using WayTo = std::function<double(const Place& place)>;
/// The same from where the robot is now; called only for an answer that depends on it. May return
/// an empty one: not known.
using WayFromHere = std::function<WayTo()>;
/// As the crow flies [m], for who has no map of the ways: another floor counts 100 m, another
/// building 1 km, a place that is not on the map 50 m.
double StraightWay(const Position& from, const Position& to);
/// The nearest ones first.
std::vector<Place> NearestPlaces(const Database& database, const std::string& category,
                                 const WayTo& way);

/// What the canteens offer on a day, in that language where it is known in it. An empty diet means
/// any; without meals of that diet a menu has none.
std::vector<MenuOfDay> MenusOn(const Database& database, Day day, const std::string& diet,
                               Language language);

/// Which departures; empty: any.
struct DepartureFilter {
  std::string line;
  std::string towards;  ///< calls there later: the name of a stop
  std::string place;    ///< where one gets in
};
struct Departure {
  WallTime when;
  std::string line, headsign;
  std::string place;  ///< where one gets in
};
/// The next `most` ones within a week, the soonest first.
std::vector<Departure> NextDepartures(const Database& database, const SiteTime& time, WallTime now,
                                      const DepartureFilter& filter, int most);

/// The robot's answer to small talk; empty if there is none.
std::string ReplyTo(const Database& database, const std::string& topic, Language language);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_STORE_QUERIES_H_
