// Opens a file of SQLite that others may have damaged or put there: what it holds is data and
// nothing else.
//
//   auto database = OpenDatabase("maps/memory.db", SQLite::OPEN_READWRITE, 1000, 16 << 20);
//
// Views and triggers of the file, which could go on for ever, are not obeyed (no file of ours has
// any); a value longer than `longest` is an error before there is memory for it; a pipe or a device
// in the place of the file, or of one of those that SQLite keeps beside it, is not waited for.
// https://www.sqlite.org/security.html
#ifndef COPPICE_ROBOT_APP_COMMON_DATABASES_OPEN_DATABASE_H_
#define COPPICE_ROBOT_APP_COMMON_DATABASES_OPEN_DATABASE_H_

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <memory>
#include <string>

namespace coppice::robot {

/// `flags` are those of SQLiteCpp, `patience` [ms] is for another program that writes, `longest`
/// [bytes] for a value. Throws SQLite::Exception, as all that is done with it.
std::unique_ptr<SQLite::Database> OpenDatabase(const std::string& path, int flags, int patience,
                                               int longest);

/// Whether an error says that the disk is full, or cannot be written or read any more.
bool IsOfTheDisk(const SQLite::Exception& error);

/// What the file holds, in memory, where the disk takes nothing, not even the log that SQLite has
/// beside a file which it reads; empty if there is no such file. Changes are forgotten. As
/// OpenDatabase; also throws if the file is larger than `largest` [bytes].
std::unique_ptr<SQLite::Database> CopyOfDatabase(const std::string& path, std::uintmax_t largest,
                                                 int longest);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_DATABASES_OPEN_DATABASE_H_
