#include "robot_app/common/databases/open_database.h"

#include <sqlite3.h>

#include <filesystem>
#include <system_error>

namespace coppice::robot {
namespace {

namespace fs = std::filesystem;

// A symbolic link leads to what it leads to.
bool IsFileOrNothing(const std::string& path) {
  std::error_code error;
  const fs::file_type type = fs::status(path, error).type();
  return type == fs::file_type::regular || type == fs::file_type::not_found;
}

}  // namespace

std::unique_ptr<SQLite::Database> OpenDatabase(const std::string& path, int flags, int patience,
                                               int longest) {
  for (const char* const part : {"", "-journal", "-wal", "-shm"}) {
    if (!path.empty() && !IsFileOrNothing(path + part)) {
      const std::string what = part[0] == '\0' ? "is no file" : "there is no file beside it, ";
      throw SQLite::Exception(what + part, SQLITE_CANTOPEN);
    }
  }
  auto database = std::make_unique<SQLite::Database>(path, flags, patience);
  sqlite3* const handle = database->getHandle();
  for (const int option : {SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_ENABLE_TRIGGER,
                           SQLITE_DBCONFIG_TRUSTED_SCHEMA}) {
    sqlite3_db_config(handle, option, 0, nullptr);
  }
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, longest);
  return database;
}

}  // namespace coppice::robot
