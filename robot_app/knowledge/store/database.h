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
  /// The same for a robot that is to start whatever its disk takes: where that is full, or cannot
  /// be written, what the file holds is copied into memory.
  static Expected<Database> OpenOrCopy(const std::string& path);

  Database(Database&& other) noexcept;
  ~Database();

  /// Whether it is a copy, of which nobody hears, and which hears of nothing.
  bool is_copy() const { return is_copy_; }

  /// Changes when another connection has written something.
  std::int64_t version() const;

  SQLite::Database& sqlite() const { return *sqlite_; }

 private:
  explicit Database(std::unique_ptr<SQLite::Database> sqlite);
  static Expected<Database> OpenAs(const std::string& path, int flags);
  static Expected<Database> Prepared(std::unique_ptr<SQLite::Database> sqlite,
                                     const std::string& path);
  Outcome Prepare(const std::string& path);
  bool IsEmpty() const;
  void Make();

  std::unique_ptr<SQLite::Database> sqlite_;
  bool is_copy_ = false;
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
