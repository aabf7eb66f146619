#include "robot_app/common/databases/open_database.h"

#include <SQLiteCpp/Backup.h>
#include <sqlite3.h>

#include <cstdio>
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

// As a URI of SQLite, in which some letters would mean something. Immutable: no log is looked for.
std::string UriOf(const std::string& path) {
  std::string uri = "file:";
  for (const char letter : path) {
    if (letter == '?' || letter == '#' || letter == '%') {
      char code[4];
      std::snprintf(code, sizeof code, "%%%02X", letter);
      uri += code;
    } else {
      uri += letter;
    }
  }
  return uri + "?immutable=1";
}

}  // namespace

bool IsOfTheDisk(const SQLite::Exception& error) {
  switch (error.getErrorCode()) {
    case SQLITE_CANTOPEN:
    case SQLITE_FULL:
    case SQLITE_IOERR:
    case SQLITE_READONLY:
      return true;
    default:
      return false;
  }
}

std::unique_ptr<SQLite::Database> CopyOfDatabase(const std::string& path, std::uintmax_t largest,
                                                 int longest) {
  auto copy = OpenDatabase(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, 0, longest);
  std::error_code error;
  if (fs::status(path, error).type() == fs::file_type::not_found) return copy;
  if (!fs::is_regular_file(path, error) || fs::file_size(path, error) > largest) {
    throw SQLite::Exception("is no file, or too large", SQLITE_CANTOPEN);
  }
  SQLite::Database file(UriOf(path), SQLite::OPEN_READONLY | SQLite::OPEN_URI);
  SQLite::Backup(*copy, file).executeStep();
  return copy;
}

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
