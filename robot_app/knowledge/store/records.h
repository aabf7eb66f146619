// What the robot knows, as the rows of its tables (schema.sql): flat lists of values that refer to
// each other by id. The import makes a Campus of a folder and writes it; queries return single
// records. What can be worked out is in none of them: phonetic codes, distances, the state of an
// opening.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_STORE_RECORDS_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_STORE_RECORDS_H_

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/knowledge/store/language.h"
#include "robot_app/knowledge/store/site_time.h"

namespace coppice::robot::knowledge {

struct Point {
  double x = 0, y = 0;  ///< m, in the frame `map`
};

/// Where something or somebody is.
struct Position {
  std::string building;
  int floor = 0;            ///< 0: ground floor
  std::optional<Point> at;  ///< nothing: not on the robot's map
};

struct Site {
  std::string time_zone;  ///< of the system's database: "Europe/Berlin"
  std::string home;       ///< the place where the robot is if nobody knows better
  std::vector<Day> holidays;
};

struct Building {
  std::string id;
  ByLanguage<std::string> name;
};

struct Place {
  std::string id;  ///< as in places.yaml
  Position position;
  std::string hours;            ///< opening_hours.h; empty: nobody says
  ByLanguage<std::string> way;  ///< a sentence for people, may be empty
};

struct PlaceCategory {
  std::string place, category;
};

struct Person {
  std::string id;
  std::string office;  ///< the id of a place; may be empty
  std::string phone;   ///< may be empty, as the next one
  std::string email;
};

struct Meal {
  std::string name;
  std::string category;
  std::optional<double> price_students, price_employees, price_others;  ///< EUR
  std::vector<std::string> diets;
};

/// What a canteen offers on a day, in the words of one language.
struct MenuOfDay {
  std::string canteen;  ///< the id of a place
  Day day;
  Language language = Language::kGerman;
  bool is_closed = false;
  std::vector<Meal> meals;
};

/// Of GTFS: calendar.txt and calendar_dates.txt.
struct Service {
  std::string id;
  Day first, last;            ///< both included; without weekdays: no matter
  std::uint8_t weekdays = 0;  ///< bit 0: Monday
};
struct ServiceException {
  std::string service;
  Day day;
  bool runs = false;  ///< else it does not, although the weekday says so
};

struct Stop {
  std::string id, name;
};
/// A stop of the timetable that is a place of the site.
struct Boarding {
  std::string stop, place;
};
struct Trip {
  std::string id, service;
  std::string line;      ///< what is written on the vehicle
  std::string headsign;  ///< likewise; never empty
};
/// A trip calls at a stop.
struct Call {
  std::string trip, stop;
  int sequence = 0;
  std::chrono::seconds departure{0};  ///< of the service's day; may exceed 24 h
  bool boards = true;                 ///< people may get in
};

struct Reply {
  std::string topic;
  Language language = Language::kEnglish;
  std::string text;
};

/// All of a folder.
struct Campus {
  Site site;
  std::vector<Name> names;
  std::vector<Building> buildings;
  std::vector<std::string> categories;
  std::vector<std::string> diets;
  std::vector<Place> places;
  std::vector<PlaceCategory> place_categories;
  std::vector<Boarding> boardings;
  std::vector<Person> people;
  std::vector<MenuOfDay> menus;
  std::vector<Service> services;
  std::vector<ServiceException> exceptions;
  std::vector<Stop> stops;
  std::vector<Trip> trips;
  std::vector<Call> calls;
  std::vector<Reply> replies;
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_STORE_RECORDS_H_
