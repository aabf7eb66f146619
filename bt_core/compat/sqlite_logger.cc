#include <sqlite3.h>

#include <algorithm>
#include <memory>

#include "behaviortree_cpp/loggers/bt_sqlite_logger.h"
#include "behaviortree_cpp/xml_parsing.h"

namespace BT {
namespace {

using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

[[noreturn]] void Throw(sqlite3* db) { throw RuntimeError("SqliteLogger: ", sqlite3_errmsg(db)); }

void Execute(sqlite3* db, const char* sql) {
  if (sqlite3_exec(db, sql, nullptr, nullptr, nullptr) != SQLITE_OK) Throw(db);
}

Statement Prepare(sqlite3* db, const char* sql) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(db, sql, -1, &statement, nullptr) != SQLITE_OK) Throw(db);
  return Statement(statement, &sqlite3_finalize);
}

void Step(sqlite3* db, sqlite3_stmt* statement) {
  if (sqlite3_step(statement) != SQLITE_DONE) Throw(db);
  sqlite3_reset(statement);
}

void BindText(sqlite3_stmt* statement, int place, const std::string& text) {
  sqlite3_bind_text(statement, place, text.c_str(), -1, SQLITE_TRANSIENT);
}

std::int64_t Microseconds(Duration duration) {
  return std::chrono::duration_cast<std::chrono::microseconds>(duration).count();
}

constexpr char kTables[] =
    "CREATE TABLE IF NOT EXISTS Transitions (timestamp INTEGER PRIMARY KEY NOT NULL, session_id "
    "INTEGER NOT NULL, node_uid INTEGER NOT NULL, duration INTEGER, state INTEGER NOT NULL, "
    "extra_data VARCHAR);"
    "CREATE TABLE IF NOT EXISTS Nodes (session_id INTEGER NOT NULL, fullpath VARCHAR, node_uid "
    "INTEGER NOT NULL);"
    "CREATE TABLE IF NOT EXISTS Definitions (session_id INTEGER PRIMARY KEY AUTOINCREMENT, date "
    "TEXT NOT NULL, xml_tree TEXT NOT NULL);";

}  // namespace

SqliteLogger::SqliteLogger(const Tree& tree, const std::filesystem::path& file, bool append) {
  const auto extension = file.extension();
  if (extension != ".db3" && extension != ".btdb") {
    throw RuntimeError("SqliteLogger: the file extension must be [.db3] or [.btdb]");
  }
  if (sqlite3_open(file.c_str(), &db_) != SQLITE_OK) {
    const std::string why = sqlite3_errmsg(db_);
    sqlite3_close(db_);
    throw RuntimeError("Cannot open database: ", why);
  }
  // What is committed with a tick waits for no disk: a robot's tick may not. A crash of the program
  // loses nothing, one of the computer the last seconds. Refused where the disk cannot do it, or
  // somebody reads the file: then it is only slower.
  sqlite3_exec(db_, "PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL", nullptr, nullptr,
               nullptr);
  Execute(db_, kTables);
  if (!append) {
    Execute(db_, "DELETE FROM Transitions; DELETE FROM Definitions; DELETE FROM Nodes;");
  }
  DescribeTree(tree);
  insert_ = Prepare(db_, "INSERT INTO Transitions VALUES (?, ?, ?, ?, ?, ?)").release();
  subscribeToTreeChanges(tree.rootNode());
}

void SqliteLogger::DescribeTree(const Tree& tree) {
  const Statement definition = Prepare(
      db_, "INSERT INTO Definitions (date, xml_tree) VALUES (datetime('now','localtime'), ?)");
  BindText(definition.get(), 1, WriteTreeToXML(tree, true, true));
  Step(db_, definition.get());
  session_id_ = static_cast<int>(sqlite3_last_insert_rowid(db_));
  const Statement row = Prepare(db_, "INSERT INTO Nodes VALUES (?, ?, ?)");
  Execute(db_, "BEGIN");
  for (const auto& subtree : tree.subtrees) {
    for (const auto& node : subtree->nodes) {
      sqlite3_bind_int(row.get(), 1, session_id_);
      BindText(row.get(), 2, node->fullPath());
      sqlite3_bind_int(row.get(), 3, node->UID());
      Step(db_, row.get());
    }
  }
  Execute(db_, "COMMIT");
}

SqliteLogger::~SqliteLogger() {
  unsubscribeFromTreeChanges();
  try {
    flush();
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
  }
  sqlite3_finalize(insert_);
  // One file again, as other programs expect; refused while one of them reads it.
  sqlite3_exec(db_, "PRAGMA journal_mode=DELETE", nullptr, nullptr, nullptr);
  sqlite3_close(db_);
}

void SqliteLogger::callback(Duration timestamp, const TreeNode& node, NodeStatus prev_status,
                            NodeStatus status) {
  const std::int64_t now = std::max(Microseconds(timestamp), last_time_ + 1);  // a key of its own
  last_time_ = now;
  std::int64_t duration = 0;
  if (status == NodeStatus::RUNNING) started_[&node] = now;
  const auto started = started_.find(&node);
  if (prev_status == NodeStatus::RUNNING && started != started_.end()) {
    duration = now - started->second;
  }
  if (pending_ == 0) Execute(db_, "BEGIN");
  sqlite3_bind_int64(insert_, 1, now);
  sqlite3_bind_int(insert_, 2, session_id_);
  sqlite3_bind_int(insert_, 3, node.UID());
  sqlite3_bind_int64(insert_, 4, duration);
  sqlite3_bind_int(insert_, 5, static_cast<int>(status));
  BindText(insert_, 6, extra_ ? extra_(timestamp, node, prev_status, status) : std::string());
  Step(db_, insert_);
  ++pending_;
}

void SqliteLogger::execSqlStatement(std::string statement) { Execute(db_, statement.c_str()); }

void SqliteLogger::flush() {
  if (pending_ == 0) return;
  pending_ = 0;
  Execute(db_, "COMMIT");
}

}  // namespace BT
