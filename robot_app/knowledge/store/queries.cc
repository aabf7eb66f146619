#include "robot_app/knowledge/store/queries.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace coppice::robot::knowledge {
namespace {

constexpr double kSomewhereHere = 50, kOtherFloor = 100, kOtherBuilding = 1000;  // m

// A sentence with its values: rows are read by Next() and Text(), Number().
class Question {
 public:
  template <class... Values>
  Question(const Database& database, const char* sql, const Values&... values)
      : statement_(database.sqlite(), sql) {
    int column = 0;
    (statement_.bind(++column, values), ...);
  }
  bool Next() { return statement_.executeStep(); }
  std::string Text(int column) { return statement_.getColumn(column).getString(); }
  int Number(int column) { return statement_.getColumn(column).getInt(); }
  std::optional<double> Real(int column) {
    const SQLite::Column value = statement_.getColumn(column);
    return value.isNull() ? std::nullopt : std::optional(value.getDouble());
  }

 private:
  SQLite::Statement statement_;
};

std::optional<Point> PointOf(std::optional<double> x, std::optional<double> y) {
  if (!x || !y) return std::nullopt;
  return Point{*x, *y};
}

constexpr const char* kPlace =
    "SELECT id, building, floor, x, y, hours, way_en, way_de FROM place ";

Place ReadPlace(Question& row) {
  return {row.Text(0),
          {row.Text(1), row.Number(2), PointOf(row.Real(3), row.Real(4))},
          row.Text(5),
          {row.Text(6), row.Text(7)}};
}

std::vector<Place> ReadPlaces(Question question) {
  std::vector<Place> places;
  while (question.Next()) places.push_back(ReadPlace(question));
  return places;
}

std::vector<Person> ReadPeople(Question question) {
  std::vector<Person> people;
  while (question.Next()) {
    people.push_back({question.Text(0), question.Text(1), question.Text(2), question.Text(3)});
  }
  return people;
}

template <class T>
std::optional<T> First(std::vector<T> list) {
  if (list.empty()) return std::nullopt;
  return std::move(list.front());
}

std::vector<std::string> DietsOf(const Database& database, int meal) {
  std::vector<std::string> diets;
  Question question(database, "SELECT diet FROM meal_diet WHERE meal = ?", meal);
  while (question.Next()) diets.push_back(question.Text(0));
  return diets;
}

std::vector<Meal> MealsOf(const Database& database, int menu, const std::string& diet) {
  std::vector<Meal> meals;
  Question question(database,
                    "SELECT id, name, category, students, employees, others FROM meal "
                    "WHERE menu = ?1 AND (?2 = '' OR EXISTS "
                    "(SELECT 1 FROM meal_diet WHERE meal = meal.id AND diet = ?2)) ORDER BY id",
                    menu, diet);
  while (question.Next()) {
    meals.push_back({question.Text(1), question.Text(2), question.Real(3), question.Real(4),
                     question.Real(5), DietsOf(database, question.Number(0))});
  }
  return meals;
}

// ?1 day, ?2 its weekday, ?3 from when, ?4 line, ?5 towards, ?6 place, ?7 how many.
constexpr const char* kDepartures = R"sql(
WITH running AS (
  SELECT id FROM service
  WHERE ?1 BETWEEN first AND last AND (weekdays >> ?2) & 1
    AND NOT EXISTS (SELECT 1 FROM service_exception
                    WHERE service = service.id AND day = ?1 AND NOT runs)
  UNION SELECT service FROM service_exception WHERE day = ?1 AND runs)
SELECT call.departure, trip.line, trip.headsign, boarding.place
FROM boarding
JOIN call ON call.stop = boarding.stop AND call.departure >= ?3 AND call.boards
JOIN trip ON trip.id = call.trip
WHERE trip.service IN running
  AND (?4 = '' OR trip.line = ?4) AND (?6 = '' OR boarding.place = ?6)
  AND (?5 = '' OR EXISTS (
    SELECT 1 FROM call later JOIN stop ON stop.id = later.stop
    WHERE later.trip = call.trip AND later.sequence > call.sequence AND stop.name = ?5))
ORDER BY call.departure LIMIT ?7
)sql";

void AddDepartures(const Database& database, const SiteTime& time, WallTime now, Day day,
                   const DepartureFilter& filter, int most, std::vector<Departure>& found) {
  const WallTime midnight = time.OfTimetable(day, std::chrono::seconds(0));
  const std::int64_t from = std::chrono::ceil<std::chrono::seconds>(now - midnight).count();
  Question question(database, kDepartures, day.number, WeekdayOf(day), from, filter.line,
                    filter.towards, filter.place, most);
  while (question.Next()) {
    found.push_back({midnight + std::chrono::seconds(question.Number(0)), question.Text(1),
                     question.Text(2), question.Text(3)});
  }
}

}  // namespace

std::optional<Site> FindSite(const Database& database) {
  Question question(database, "SELECT time_zone, home FROM site");
  if (!question.Next()) return std::nullopt;
  return Site{question.Text(0), question.Text(1), {}};
}

Expected<SiteTime> TimeOf(const Database& database) {
  const std::optional<Site> site = FindSite(database);
  if (!site) return Problem{"there is no knowledge yet: `coppice-knowledge import`"};
  return SiteTime::Find(site->time_zone);
}

bool IsHoliday(const Database& database, Day day) {
  return Question(database, "SELECT 1 FROM holiday WHERE day = ?", day.number).Next();
}

std::vector<Name> Names(const Database& database) {
  std::vector<Name> names;
  Question question(database,
                    "SELECT kind, subject, language, text, is_main FROM name UNION ALL "
                    "SELECT kind, subject, language, text, 0 FROM synonym");
  while (question.Next()) {
    const auto kind = KindOf(question.Text(0));
    const auto language = LanguageOf(question.Text(2));
    if (!kind || !language) continue;
    names.push_back(
        {*kind, question.Text(1), *language, question.Text(3), question.Number(4) != 0});
  }
  return names;
}

std::string NameOf(const Database& database, Kind kind, const std::string& subject,
                   Language language) {
  Question question(database,
                    "SELECT text FROM name WHERE kind = ?1 AND subject = ?2 AND is_main "
                    "ORDER BY language = ?3 DESC",
                    Word(kind), subject, Code(language));
  return question.Next() ? question.Text(0) : subject;
}

std::string BuildingName(const Database& database, const std::string& building, Language language) {
  Question question(database, "SELECT en, de FROM building WHERE id = ?", building);
  return question.Next() ? question.Text(static_cast<int>(language)) : building;
}

std::optional<Place> FindPlace(const Database& database, const std::string& id) {
  static const std::string sql = std::string(kPlace) + "WHERE id = ?";
  return First(ReadPlaces(Question(database, sql.c_str(), id)));
}

std::vector<Place> PlacesOf(const Database& database, const std::string& category) {
  static const std::string sql =
      std::string(kPlace) + "JOIN place_category ON place = id WHERE category = ? ORDER BY rowid";
  return ReadPlaces(Question(database, sql.c_str(), category));
}

std::optional<Person> FindPerson(const Database& database, const std::string& id) {
  return First(ReadPeople(Question(
      database, "SELECT id, ifnull(office, ''), phone, email FROM person WHERE id = ?", id)));
}

std::vector<Person> PeopleIn(const Database& database, const std::string& place) {
  return ReadPeople(Question(
      database, "SELECT id, office, phone, email FROM person WHERE office = ? ORDER BY rowid",
      place));
}

double StraightWay(const Position& from, const Position& to) {
  if (from.building != to.building) return kOtherBuilding;
  const double floors = kOtherFloor * std::abs(from.floor - to.floor);
  if (!from.at || !to.at) return floors + kSomewhereHere;
  return floors + std::hypot(from.at->x - to.at->x, from.at->y - to.at->y);
}

std::vector<Place> NearestPlaces(const Database& database, const std::string& category,
                                 const WayTo& way) {
  std::vector<Place> places = PlacesOf(database, category);
  std::vector<std::pair<double, Place>> by_way;
  for (Place& place : places) by_way.emplace_back(way(place), std::move(place));
  std::stable_sort(by_way.begin(), by_way.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::transform(by_way.begin(), by_way.end(), places.begin(),
                 [](auto& one) { return std::move(one.second); });
  return places;
}

std::vector<MenuOfDay> MenusOn(const Database& database, Day day, const std::string& diet,
                               Language language) {
  std::vector<MenuOfDay> menus;
  Question question(database,
                    "SELECT id, canteen, language, is_closed FROM menu WHERE day = ? "
                    "ORDER BY canteen, language = ? DESC",
                    day.number, Code(language));
  while (question.Next()) {
    const std::string canteen = question.Text(1);
    if (!menus.empty() && menus.back().canteen == canteen) continue;  // in another language
    menus.push_back({canteen, day, LanguageOf(question.Text(2)).value_or(language),
                     question.Number(3) != 0, MealsOf(database, question.Number(0), diet)});
  }
  return menus;
}

std::vector<Departure> NextDepartures(const Database& database, const SiteTime& time, WallTime now,
                                      const DepartureFilter& filter, int most) {
  // Trips of yesterday may still run; of tomorrow's, the first may come before the last of today.
  const Day today = time.Local(now).day;
  std::vector<Departure> found;
  for (Day day = today + -1; day <= today + 7; day = day + 1) {
    if (today + 1 < day && static_cast<int>(found.size()) >= most) break;
    AddDepartures(database, time, now, day, filter, most, found);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Departure& a, const Departure& b) { return a.when < b.when; });
  if (static_cast<int>(found.size()) > most) found.resize(static_cast<std::size_t>(most));
  return found;
}

std::string ReplyTo(const Database& database, const std::string& topic, Language language) {
  Question question(database, "SELECT text FROM reply WHERE topic = ? ORDER BY language = ? DESC",
                    topic, Code(language));
  return question.Next() ? question.Text(0) : std::string();
}

}  // namespace coppice::robot::knowledge
