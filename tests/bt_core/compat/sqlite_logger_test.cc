// A database as SqliteLogger of BehaviorTree.CPP 4 writes it and Groot2 reads it.
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "behaviortree_cpp/loggers/bt_sqlite_logger.h"
#include "behaviortree_cpp/xml_parsing.h"
#include "tests/bt_core/compat/logged_tree.h"
#include "tests/support/temporary_folder.h"

namespace {

using compat_test::LoggedTree;
using Rows = std::vector<std::vector<std::string>>;

struct SqliteFile : testing::Test {
  Rows Ask(const std::string& sql) const {
    sqlite3* opened = nullptr;
    EXPECT_EQ(sqlite3_open(path.c_str(), &opened), SQLITE_OK);
    const std::unique_ptr<sqlite3, int (*)(sqlite3*)> db(opened, &sqlite3_close);
    Rows rows;
    const auto add = [](void* to, int count, char** values, char**) {
      auto& row = static_cast<Rows*>(to)->emplace_back();
      for (int k = 0; k < count; ++k) row.emplace_back(values[k] ? values[k] : "NULL");
      return 0;
    };
    char* error = nullptr;
    EXPECT_EQ(sqlite3_exec(db.get(), sql.c_str(), add, &rows, &error), SQLITE_OK)
        << sql << ": " << error;
    sqlite3_free(error);
    return rows;
  }
  void Run(bool append = false) {
    BT::SqliteLogger logger(logged.tree, path, append);
    logged.tree.tickExactlyOnce();
    logged.tree.tickExactlyOnce();
  }

  coppice::TemporaryFolder folder;
  std::string path = folder.Path("run.db3");
  LoggedTree logged;
};

TEST_F(SqliteFile, HasThreeTablesWithTheirColumns) {
  Run();
  const auto columns = [this](const std::string& table) {
    return Ask("SELECT name, type, pk FROM pragma_table_info('" + table + "')");
  };
  EXPECT_EQ(columns("Transitions"), (Rows{{"timestamp", "INTEGER", "1"},
                                          {"session_id", "INTEGER", "0"},
                                          {"node_uid", "INTEGER", "0"},
                                          {"duration", "INTEGER", "0"},
                                          {"state", "INTEGER", "0"},
                                          {"extra_data", "VARCHAR", "0"}}));
  EXPECT_EQ(columns("Nodes"), (Rows{{"session_id", "INTEGER", "0"},
                                    {"fullpath", "VARCHAR", "0"},
                                    {"node_uid", "INTEGER", "0"}}));
  EXPECT_EQ(
      columns("Definitions"),
      (Rows{{"session_id", "INTEGER", "1"}, {"date", "TEXT", "0"}, {"xml_tree", "TEXT", "0"}}));
}

TEST_F(SqliteFile, HasTheTree) {
  Run();
  EXPECT_EQ(Ask("SELECT xml_tree FROM Definitions"),
            (Rows{{BT::WriteTreeToXML(logged.tree, true, true)}}));
}

TEST_F(SqliteFile, NamesItsNodesByPath) {
  Run();
  EXPECT_EQ(Ask("SELECT session_id, node_uid, fullpath FROM Nodes"),
            (Rows{{"1", "1", "Fallback::1"},
                  {"1", "2", "Inverter::2"},
                  {"1", "3", "go"},
                  {"1", "4", "inner"},
                  {"1", "5", "inner/yes"}}));
}

TEST_F(SqliteFile, HoldsEveryChangeInItsOrder) {
  Run();
  EXPECT_EQ(Ask("SELECT node_uid, state FROM Transitions ORDER BY timestamp"), (Rows{{"1", "1"},
                                                                                     {"2", "1"},
                                                                                     {"3", "1"},
                                                                                     {"3", "2"},
                                                                                     {"3", "0"},
                                                                                     {"2", "3"},
                                                                                     {"4", "1"},
                                                                                     {"5", "2"},
                                                                                     {"5", "0"},
                                                                                     {"4", "2"},
                                                                                     {"2", "0"},
                                                                                     {"4", "0"},
                                                                                     {"1", "2"},
                                                                                     {"1", "0"}}));
}

TEST_F(SqliteFile, SaysHowLongANodeRan) {
  Run();
  EXPECT_EQ(Ask("SELECT ended.duration - (ended.timestamp - begun.timestamp) "
                "FROM Transitions AS begun, Transitions AS ended "
                "WHERE begun.node_uid = 3 AND begun.state = 1 "
                "AND ended.node_uid = 3 AND ended.state = 2"),
            (Rows{{"0"}}));
}

TEST_F(SqliteFile, KeepsWhatTheUserAdds) {
  {
    BT::SqliteLogger logger(logged.tree, path, false);
    logger.setAdditionalCallback([](BT::Duration, const BT::TreeNode& node, BT::NodeStatus,
                                    BT::NodeStatus) { return "of " + node.name(); });
    logged.tree.tickExactlyOnce();
  }
  EXPECT_EQ(Ask("SELECT DISTINCT extra_data FROM Transitions WHERE node_uid = 3"),
            (Rows{{"of go"}}));
}

TEST_F(SqliteFile, IsBegunAnewUnlessItIsToBeContinued) {
  Run();
  Run();
  EXPECT_EQ(Ask("SELECT count(*) FROM Definitions"), (Rows{{"1"}}));
  Run(true);
  EXPECT_EQ(Ask("SELECT count(*) FROM Definitions"), (Rows{{"2"}}));
  EXPECT_EQ(Ask("SELECT count(DISTINCT session_id) FROM Transitions"), (Rows{{"2"}}));
}

TEST_F(SqliteFile, OthersSeeATickWhenItHasEnded) {
  BT::SqliteLogger logger(logged.tree, path, false);
  logged.tree.tickExactlyOnce();
  EXPECT_EQ(Ask("SELECT count(*) FROM Transitions"), (Rows{{"3"}}));
}

TEST_F(SqliteFile, WaitsForNoDiskWhileItRunsAndIsOneFileAfterwards) {
  {
    BT::SqliteLogger logger(logged.tree, path, false);
    logged.tree.tickExactlyOnce();
    EXPECT_EQ(Ask("PRAGMA journal_mode"), (Rows{{"wal"}}));  // commits do not sync
  }
  EXPECT_EQ(Ask("PRAGMA journal_mode"), (Rows{{"delete"}}));
  const std::filesystem::directory_iterator files(folder.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST_F(SqliteFile, WantsItsExtension) {
  EXPECT_THROW(BT::SqliteLogger(logged.tree, folder.Path("run.sqlite"), false), BT::RuntimeError);
}

}  // namespace
