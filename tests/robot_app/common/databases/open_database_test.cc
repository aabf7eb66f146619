#include "robot_app/common/databases/open_database.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace coppice::robot {
namespace {

const int kMake = SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE;

class OpenDatabaseTest : public testing::Test {
 protected:
  std::unique_ptr<SQLite::Database> Open() const { return OpenDatabase(file_, kMake, 100, 1000); }

  TemporaryFolder folder_;
  const std::string file_ = folder_.Path("some.db");
};

TEST_F(OpenDatabaseTest, AViewWithoutEndIsNotFollowed) {
  SQLite::Database(file_, kMake)
      .exec(
          "CREATE VIEW v AS WITH RECURSIVE c(n) AS (SELECT 0 UNION ALL SELECT n + 1 FROM c) "
          "SELECT n FROM c");
  EXPECT_THROW(Open()->execAndGet("SELECT count(*) FROM v"), SQLite::Exception);
}

TEST_F(OpenDatabaseTest, ATriggerDoesNothing) {
  SQLite::Database(file_, kMake)
      .exec("CREATE TABLE t (n); CREATE TRIGGER r AFTER INSERT ON t BEGIN DELETE FROM t; END");
  const auto database = Open();
  database->exec("INSERT INTO t VALUES (1)");
  EXPECT_EQ(database->execAndGet("SELECT count(*) FROM t").getInt(), 1);
}

TEST_F(OpenDatabaseTest, AValueLongerThanItMayBeIsAnError) {
  SQLite::Database(file_, kMake).exec("CREATE TABLE t (n); INSERT INTO t VALUES (zeroblob(1001))");
  EXPECT_THROW(Open()->execAndGet("SELECT n FROM t"), SQLite::Exception);
  EXPECT_THROW(Open()->execAndGet("SELECT zeroblob(900000000)"), SQLite::Exception);
}

TEST_F(OpenDatabaseTest, WhatIsNoFileIsNotWaitedFor) {
  for (const char* const part : {"", "-journal", "-wal"}) {
    const std::string pipe = file_ + part;
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(Open(), SQLite::Exception) << part;
    std::filesystem::remove(pipe);
  }
  std::filesystem::create_symlink("/dev/zero", file_);
  EXPECT_THROW(Open(), SQLite::Exception);
}

TEST_F(OpenDatabaseTest, ACopyHasWhatTheFileHoldsAndItsChangesAreForgotten) {
  const std::string file = folder_.Path("what?#%41.db");
  SQLite::Database(file, kMake).exec("PRAGMA journal_mode = WAL; CREATE TABLE t (n)");
  SQLite::Database(file, kMake).exec("INSERT INTO t VALUES (7)");
  std::filesystem::create_directories(file + "-shm");  // there is no room for the log
  EXPECT_THROW(OpenDatabase(file, kMake, 100, 1000), SQLite::Exception);
  const auto copy = CopyOfDatabase(file, 1 << 20, 1000);
  EXPECT_EQ(copy->execAndGet("SELECT n FROM t").getInt(), 7);
  copy->exec("DELETE FROM t");
  EXPECT_EQ(CopyOfDatabase(file, 1 << 20, 1000)->execAndGet("SELECT n FROM t").getInt(), 7);
  EXPECT_THROW(CopyOfDatabase(file, 100, 1000), SQLite::Exception) << "too large";
}

TEST_F(OpenDatabaseTest, ACopyOfNothingIsEmptyAndAPipeIsNotWaitedFor) {
  EXPECT_EQ(
      CopyOfDatabase(file_, 100, 100)->execAndGet("SELECT count(*) FROM sqlite_master").getInt(),
      0);
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  EXPECT_THROW(CopyOfDatabase(file_, 100, 100), SQLite::Exception);
}

}  // namespace
}  // namespace coppice::robot
