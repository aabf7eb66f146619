// The tables of the knowledge in SQLite. All but the last two are written by the import alone, in
// one transaction; the last two are written while the robot serves, and outlive an import.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_STORE_SCHEMA_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_STORE_SCHEMA_H_

namespace coppice::robot::knowledge {

/// In the header of the file (PRAGMA application_id): whose file it is.
inline constexpr int kApplicationId = 0x434b4e4f;
/// PRAGMA user_version: goes up with every change of the tables.
inline constexpr int kSchemaVersion = 1;

inline constexpr const char* kSchema = R"sql(
-- Days count from 1970-01-01, times are seconds of the day, lengths are metres.
CREATE TABLE site (time_zone TEXT NOT NULL, home TEXT NOT NULL);
CREATE TABLE holiday (day INTEGER PRIMARY KEY);

-- What subjects are called. kind: language.h.
CREATE TABLE name (
  kind TEXT NOT NULL, subject TEXT NOT NULL, language TEXT NOT NULL, text TEXT NOT NULL,
  is_main INTEGER NOT NULL,
  UNIQUE (kind, subject, language, text));
CREATE TABLE building (id TEXT PRIMARY KEY, en TEXT NOT NULL, de TEXT NOT NULL);
CREATE TABLE category (id TEXT PRIMARY KEY);
CREATE TABLE diet (id TEXT PRIMARY KEY);
CREATE TABLE place (
  id TEXT PRIMARY KEY, building TEXT NOT NULL REFERENCES building, floor INTEGER NOT NULL,
  x REAL, y REAL, hours TEXT NOT NULL, way_en TEXT NOT NULL, way_de TEXT NOT NULL);
CREATE TABLE place_category (
  category TEXT NOT NULL REFERENCES category, place TEXT NOT NULL REFERENCES place,
  PRIMARY KEY (category, place)) WITHOUT ROWID;
CREATE TABLE person (
  id TEXT PRIMARY KEY, office TEXT REFERENCES place, phone TEXT NOT NULL, email TEXT NOT NULL);

CREATE TABLE menu (
  id INTEGER PRIMARY KEY, canteen TEXT NOT NULL REFERENCES place, day INTEGER NOT NULL,
  language TEXT NOT NULL, is_closed INTEGER NOT NULL,
  UNIQUE (day, canteen, language));
CREATE TABLE meal (
  id INTEGER PRIMARY KEY, menu INTEGER NOT NULL REFERENCES menu, name TEXT NOT NULL,
  category TEXT NOT NULL, students REAL, employees REAL, others REAL);
CREATE INDEX meal_menu ON meal (menu);
CREATE TABLE meal_diet (
  meal INTEGER NOT NULL REFERENCES meal, diet TEXT NOT NULL REFERENCES diet,
  PRIMARY KEY (meal, diet));

-- Of GTFS. boards: people may get in.
CREATE TABLE service (
  id TEXT PRIMARY KEY, first INTEGER NOT NULL, last INTEGER NOT NULL, weekdays INTEGER NOT NULL);
CREATE TABLE service_exception (
  service TEXT NOT NULL REFERENCES service, day INTEGER NOT NULL, runs INTEGER NOT NULL,
  PRIMARY KEY (day, service));
CREATE TABLE stop (id TEXT PRIMARY KEY, name TEXT NOT NULL);
CREATE TABLE boarding (
  stop TEXT PRIMARY KEY REFERENCES stop, place TEXT NOT NULL REFERENCES place);
CREATE TABLE trip (
  id TEXT PRIMARY KEY, service TEXT NOT NULL REFERENCES service, line TEXT NOT NULL,
  headsign TEXT NOT NULL);
CREATE TABLE call (
  trip TEXT NOT NULL REFERENCES trip, sequence INTEGER NOT NULL,
  stop TEXT NOT NULL REFERENCES stop, departure INTEGER NOT NULL, boards INTEGER NOT NULL,
  PRIMARY KEY (trip, sequence)) WITHOUT ROWID;
CREATE INDEX call_stop ON call (stop, departure);

CREATE TABLE reply (
  topic TEXT NOT NULL, language TEXT NOT NULL, text TEXT NOT NULL,
  PRIMARY KEY (topic, language));

-- What nobody could answer, and names that the operator has added.
CREATE TABLE unknown (
  text TEXT NOT NULL, language TEXT NOT NULL, count INTEGER NOT NULL, last TEXT NOT NULL,
  PRIMARY KEY (text, language)) WITHOUT ROWID;
CREATE TABLE synonym (
  kind TEXT NOT NULL, subject TEXT NOT NULL, language TEXT NOT NULL, text TEXT NOT NULL,
  PRIMARY KEY (kind, subject, language, text)) WITHOUT ROWID;
)sql";

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_STORE_SCHEMA_H_
