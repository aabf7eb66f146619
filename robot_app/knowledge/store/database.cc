#include "robot_app/knowledge/store/database.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include "robot_app/common/databases/open_database.h"
#include "robot_app/knowledge/store/schema.h"

namespace coppice::robot::knowledge {
namespace {

constexpr int kPatience = 5000;                                    // ms, with another writer
constexpr int kLongestValue = 16 << 20;                            // bytes
constexpr std::uintmax_t kLargestCopy = std::uintmax_t{64} << 20;  // bytes

}  // namespace

Database::Database(std::unique_ptr<SQLite::Database> sqlite) : sqlite_(std::move(sqlite)) {}
Database::Database(Database&& other) noexcept = default;
Database::~Database() = default;

Expected<Database> Database::Open(const std::string& path) {
  return OpenAs(path, SQLite::OPEN_READWRITE);
}

Expected<Database> Database::OpenOrCreate(const std::string& path) {
  return OpenAs(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
}

Expected<Database> Database::OpenAs(const std::string& path, int flags) {
  try {
    return Prepared(OpenDatabase(path, flags, kPatience, kLongestValue), path);
  } catch (const SQLite::Exception& error) {
    return Problem{path + ": " + error.what()};
  }
}

Expected<Database> Database::OpenOrCopy(const std::string& path) {
  try {
    return Prepared(
        OpenDatabase(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kPatience, kLongestValue),
        path);
  } catch (const SQLite::Exception& error) {
    if (!IsOfTheDisk(error)) return Problem{path + ": " + error.what()};
  }
  try {
    auto database = Prepared(CopyOfDatabase(path, kLargestCopy, kLongestValue), path);
    if (database) database->is_copy_ = true;
    return database;
  } catch (const SQLite::Exception& error) {
    return Problem{path + ": " + error.what()};
  }
}

// Throws SQLite::Exception.
Expected<Database> Database::Prepared(std::unique_ptr<SQLite::Database> sqlite,
                                      const std::string& path) {
  Database database(std::move(sqlite));
  const Outcome outcome = database.Prepare(path);
  if (!outcome) return Problem{outcome.problem()};
  return database;
}

// Who makes the file does it in one transaction, so nobody sees it half made.
void Database::Make() {
  SQLite::Transaction transaction(*sqlite_, SQLite::TransactionBehavior::IMMEDIATE);
  if (!IsEmpty()) return;  // somebody was faster
  sqlite_->exec(kSchema);
  sqlite_->exec("PRAGMA application_id = " + std::to_string(kApplicationId));
  sqlite_->exec("PRAGMA user_version = " + std::to_string(kSchemaVersion));
  transaction.commit();
}

bool Database::IsEmpty() const {
  return sqlite_->execAndGet("PRAGMA application_id").getInt() == 0 &&
         sqlite_->execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
}

Outcome Database::Prepare(const std::string& path) {
  if (IsEmpty()) Make();
  if (sqlite_->execAndGet("PRAGMA application_id").getInt() != kApplicationId) {
    return Problem{path + ": a database of another program"};
  }
  if (sqlite_->execAndGet("PRAGMA user_version").getInt() != kSchemaVersion) {
    return Problem{path + ": made by another version of Coppice; import into a new file"};
  }
  sqlite_->exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; PRAGMA foreign_keys = ON");
  return {};
}

std::int64_t Database::version() const {
  return sqlite_->execAndGet("PRAGMA data_version").getInt64();
}

Snapshot::Snapshot(const Database& database)
    : transaction_(std::make_unique<SQLite::Transaction>(database.sqlite())) {}
Snapshot::~Snapshot() = default;

}  // namespace coppice::robot::knowledge
