// The tables of the spool.
#ifndef COPPICE_ROBOT_APP_STORAGE_SPOOL_SCHEMA_H_
#define COPPICE_ROBOT_APP_STORAGE_SPOOL_SCHEMA_H_

namespace coppice::robot::storage {

inline constexpr int kApplicationId = 0x436f5370;  // "CoSp"
inline constexpr int kSchemaVersion = 1;

// AUTOINCREMENT: a number is never given again, also when its document has gone. The index is the
// order in which documents are sent, and, backwards by priority, in which they are given up.
inline constexpr const char* kSchema = R"sql(
CREATE TABLE spool (name TEXT NOT NULL);
INSERT INTO spool VALUES (lower(hex(randomblob(8))));
CREATE TABLE types (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  md5 TEXT NOT NULL,
  definition TEXT NOT NULL,
  UNIQUE (name, md5));
CREATE TABLE documents (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  priority INTEGER NOT NULL,
  received INTEGER NOT NULL,
  stamp INTEGER NOT NULL,
  topic TEXT NOT NULL,
  type INTEGER NOT NULL REFERENCES types,
  json TEXT NOT NULL);
CREATE INDEX documents_in_order ON documents (priority DESC, number);
CREATE TABLE refused (
  number INTEGER PRIMARY KEY,
  received INTEGER NOT NULL,
  stamp INTEGER NOT NULL,
  topic TEXT NOT NULL,
  type INTEGER NOT NULL REFERENCES types,
  json TEXT NOT NULL,
  reason TEXT NOT NULL);
CREATE TABLE losses (
  topic TEXT NOT NULL,
  reason TEXT NOT NULL,
  count INTEGER NOT NULL,
  first INTEGER NOT NULL,
  last INTEGER NOT NULL,
  PRIMARY KEY (topic, reason));
)sql";

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_SPOOL_SCHEMA_H_
