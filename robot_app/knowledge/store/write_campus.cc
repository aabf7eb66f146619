#include "robot_app/knowledge/store/write_campus.h"

#include <SQLiteCpp/SQLiteCpp.h>

namespace coppice::robot::knowledge {
namespace {

constexpr const char* kForget = R"sql(
DELETE FROM meal_diet; DELETE FROM meal; DELETE FROM menu; DELETE FROM diet;
DELETE FROM call; DELETE FROM trip; DELETE FROM boarding; DELETE FROM stop;
DELETE FROM service_exception; DELETE FROM service;
DELETE FROM person; DELETE FROM place_category; DELETE FROM place; DELETE FROM category;
DELETE FROM building;
DELETE FROM reply; DELETE FROM name; DELETE FROM holiday; DELETE FROM site;
)sql";

// Rows of one table, each of which is values in the order of its columns.
class Table {
 public:
  Table(SQLite::Database& database, const std::string& name, int columns)
      : insert_(database, Sentence(name, columns)) {}

  template <class... Values>
  void Add(const Values&... values) {
    insert_.reset();
    int column = 0;
    (Bind(++column, values), ...);
    insert_.exec();
  }

 private:
  static std::string Sentence(const std::string& name, int columns) {
    std::string marks = "?";
    for (int i = 1; i < columns; ++i) marks += ",?";
    return "INSERT OR IGNORE INTO " + name + " VALUES (" + marks + ")";
  }
  void Bind(int column, const std::string& text) { insert_.bindNoCopy(column, text); }
  void Bind(int column, const char* text) { insert_.bind(column, text); }
  void Bind(int column, std::int64_t number) { insert_.bind(column, number); }
  void Bind(int column, int number) { insert_.bind(column, number); }
  void Bind(int column, bool value) { insert_.bind(column, value ? 1 : 0); }
  void Bind(int column, Day day) { insert_.bind(column, day.number); }
  void Bind(int column, std::chrono::seconds time) {
    insert_.bind(column, static_cast<std::int64_t>(time.count()));
  }
  void Bind(int column, std::nullptr_t) { insert_.bind(column); }
  void Bind(int column, const std::optional<double>& number) {
    if (number) {
      insert_.bind(column, *number);
    } else {
      insert_.bind(column);
    }
  }

  SQLite::Statement insert_;
};

std::optional<double> X(const Position& position) {
  return position.at ? std::optional(position.at->x) : std::nullopt;
}
std::optional<double> Y(const Position& position) {
  return position.at ? std::optional(position.at->y) : std::nullopt;
}

void WriteSite(SQLite::Database& database, const Campus& campus) {
  Table(database, "site", 2).Add(campus.site.time_zone, campus.site.home);
  Table holidays(database, "holiday", 1);
  for (const Day day : campus.site.holidays) holidays.Add(day);
  Table names(database, "name", 5);
  for (const Name& name : campus.names) {
    names.Add(Word(name.kind), name.subject, Code(name.language), name.text, name.is_main);
  }
  Table replies(database, "reply", 3);
  for (const Reply& reply : campus.replies) {
    replies.Add(reply.topic, Code(reply.language), reply.text);
  }
}

void WritePlaces(SQLite::Database& database, const Campus& campus) {
  Table buildings(database, "building", 3);
  for (const Building& building : campus.buildings) {
    buildings.Add(building.id, In(Language::kEnglish, building.name),
                  In(Language::kGerman, building.name));
  }
  Table categories(database, "category", 1);
  for (const std::string& category : campus.categories) categories.Add(category);
  Table places(database, "place", 8);
  for (const Place& place : campus.places) {
    places.Add(place.id, place.position.building, place.position.floor, X(place.position),
               Y(place.position), place.hours, In(Language::kEnglish, place.way),
               In(Language::kGerman, place.way));
  }
  Table place_categories(database, "place_category", 2);
  for (const PlaceCategory& one : campus.place_categories) {
    place_categories.Add(one.category, one.place);
  }
  Table people(database, "person", 4);
  for (const Person& person : campus.people) {
    if (person.office.empty()) {
      people.Add(person.id, nullptr, person.phone, person.email);
    } else {
      people.Add(person.id, person.office, person.phone, person.email);
    }
  }
}

void WriteMenus(SQLite::Database& database, const Campus& campus) {
  Table diets(database, "diet", 1);
  for (const std::string& diet : campus.diets) diets.Add(diet);
  Table menus(database, "menu", 5);
  Table meals(database, "meal", 7);
  Table meal_diets(database, "meal_diet", 2);
  for (const MenuOfDay& menu : campus.menus) {
    menus.Add(nullptr, menu.canteen, menu.day, Code(menu.language), menu.is_closed);
    const std::int64_t id = database.getLastInsertRowid();
    for (const Meal& meal : menu.meals) {
      meals.Add(nullptr, id, meal.name, meal.category, meal.price_students, meal.price_employees,
                meal.price_others);
      const std::int64_t meal_id = database.getLastInsertRowid();
      for (const std::string& diet : meal.diets) meal_diets.Add(meal_id, diet);
    }
  }
}

void WriteTimetable(SQLite::Database& database, const Campus& campus) {
  Table services(database, "service", 4);
  for (const Service& service : campus.services) {
    services.Add(service.id, service.first, service.last, static_cast<int>(service.weekdays));
  }
  Table exceptions(database, "service_exception", 3);
  for (const ServiceException& exception : campus.exceptions) {
    exceptions.Add(exception.service, exception.day, exception.runs);
  }
  Table stops(database, "stop", 2);
  for (const Stop& stop : campus.stops) stops.Add(stop.id, stop.name);
  Table boardings(database, "boarding", 2);
  for (const Boarding& boarding : campus.boardings) boardings.Add(boarding.stop, boarding.place);
  Table trips(database, "trip", 4);
  for (const Trip& trip : campus.trips) trips.Add(trip.id, trip.service, trip.line, trip.headsign);
  Table calls(database, "call", 5);
  for (const Call& call : campus.calls) {
    calls.Add(call.trip, call.sequence, call.stop, call.departure, call.boards);
  }
}

}  // namespace

Outcome WriteCampus(Database& database, const Campus& campus) {
  SQLite::Database& sqlite = database.sqlite();
  try {
    SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    sqlite.exec(kForget);
    WriteSite(sqlite, campus);
    WritePlaces(sqlite, campus);
    WriteMenus(sqlite, campus);
    WriteTimetable(sqlite, campus);
    transaction.commit();
    return {};
  } catch (const SQLite::Exception& error) {
    return Problem{std::string("the knowledge was not written: ") + error.what()};
  }
}

}  // namespace coppice::robot::knowledge
