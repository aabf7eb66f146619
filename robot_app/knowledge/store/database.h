// The file of the knowledge: one SQLite database, read by the robot while an import replaces what
// is in it (write-ahead log: nobody waits for a reader, a reader sees all of one import or all of
// the next one, an import that is killed has not been).
//
//   Expected<Database> database = Database::Open("campus.db");
//   const Snapshot snapshot(*database);            // what is read now belongs together
//   for (const Name& name : Names(*database)) ...
//
// For one thread. A file that is damaged throws std::runtime_error when it is read.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_STORE_DATABASE_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_STORE_DATABASE_H_

#include <cstdint>
#include <memory>
#include <string>

#include "bt_core/base/outcome.h"

namespace SQLite {
class Database;
class Transaction;
}  // namespace SQLite

namespace coppice::robot::knowledge {

class Database {
 public:
  static Expected<Database> Open(const std::string& path);
  /// Makes the file, without knowledge, if it is missing or empty. One of others is left alone.
  static Expected<Database> OpenOrCreate(const std::string& path);

  Database(Database&& other) noexcept;
  ~Database();

  /// Changes when another connection has written something.
  std::int64_t version() const;

  SQLite::Database& sqlite() const { return *sqlite_; }

 private:
  explicit Database(std::unique_ptr<SQLite::Database> sqlite);
  static Expected<Database> OpenAs(const std::string& path, int flags);
  Outcome Prepare(const std::string& path);
  bool IsEmpty() const;
  void Make();

  std::unique_ptr<SQLite::Database> sqlite_;
};

/// While it lives, what is read is of one moment.
class Snapshot {
 public:
  explicit Snapshot(const Database& database);
  ~Snapshot();
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

 private:
  std::unique_ptr<SQLite::Transaction> transaction_;
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_STORE_DATABASE_H_
