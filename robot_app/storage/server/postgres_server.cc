#include "robot_app/storage/server/postgres_server.h"

#include <sys/socket.h>

#include <algorithm>
#include <pqxx/pqxx>
#include <set>
#include <utility>

#include "bt_core/base/json.h"
#include "robot_app/storage/server/calendar.h"
#include "robot_app/storage/server/postgres_schema.h"

namespace coppice::robot::storage {
namespace {

using Answer = StoreResult::Answer;

// Stores make tables and partitions one after the other (pg_advisory_xact_lock).
constexpr const char* kMakerLock = "SELECT pg_advisory_xact_lock(1131376752)";

constexpr const char* kInsert =
    "INSERT INTO coppice.messages "
    "SELECT $1, $2, number, time, stamp, topic, type, md5, document FROM json_to_recordset($3) "
    "AS row(number bigint, time timestamptz, stamp bigint, topic text, type text, md5 text, "
    "document jsonb) ON CONFLICT DO NOTHING";

constexpr const char* kInsertLosses =
    "INSERT INTO coppice.losses "
    "SELECT $1, $2, topic, reason, count, first, last FROM json_to_recordset($3) "
    "AS row(topic text, reason text, count bigint, first timestamptz, last timestamptz) "
    "ON CONFLICT (robot, spool, topic, reason) DO UPDATE "
    "SET count = excluded.count, last = excluded.last WHERE losses.count < excluded.count";

std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

std::string Rows(const Batch& batch) {
  return JsonArray(batch.documents, [](const Document& document) {
    return JsonObject()
        .Add("number", std::to_string(document.number))
        .AddText("time", MomentText(document.received))
        .Add("stamp", std::to_string(document.stamp))
        .AddText("topic", document.topic)
        .AddText("type", document.type->name)
        .AddText("md5", document.type->md5)
        .Add("document", document.json)
        .Finish();
  });
}

std::string LossRows(const Batch& batch) {
  return JsonArray(batch.losses, [](const Loss& loss) {
    return JsonObject()
        .AddText("topic", loss.topic)
        .AddText("reason", loss.reason)
        .Add("count", std::to_string(loss.count))
        .AddText("first", MomentText(loss.first))
        .AddText("last", MomentText(loss.last))
        .Finish();
  });
}

void MakeSchema(pqxx::work& work) {
  work.exec(kMakerLock);
  const pqxx::row there = work.exec1("SELECT to_regclass('coppice.messages') IS NOT NULL");
  if (!there[0].as<bool>()) work.exec(kPostgresSchema);
}

// From `day`, "2026-11-25", to the next one.
void MakePartition(pqxx::work& work, const std::string& day, const std::string& next) {
  std::string name = "coppice.messages_" + day;
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  if (!work.exec1("SELECT to_regclass('" + name + "') IS NULL")[0].as<bool>()) return;
  work.exec(kMakerLock);
  work.exec("CREATE TABLE IF NOT EXISTS " + name +
            " PARTITION OF coppice.messages FOR VALUES FROM ('" + day + " 00:00+00') TO ('" + next +
            " 00:00+00')");
}

void AddType(pqxx::work& work, const MessageType& type) {
  work.exec_params("INSERT INTO coppice.types VALUES ($1, $2, $3) ON CONFLICT DO NOTHING",
                   type.name, type.md5, type.definition);
}

// Of the documents themselves (SQLSTATE): data that cannot be, values that must not be, limits.
bool IsAboutTheData(const std::string& state) {
  const std::string kind = state.substr(0, 2);
  return kind == "22" || kind == "23" || kind == "54";
}

std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

std::string ConnectionText(const ServerConfig& config) {
  // A network that fails is noticed after half a minute, not after two hours.
  std::string text =
      "application_name='coppice-store' client_encoding='UTF8' connect_timeout='5' "
      "keepalives_idle='10' keepalives_interval='5' keepalives_count='3' "
      "tcp_user_timeout='30000'";
  const auto add = [&](const char* key, const std::string& value) {
    if (!value.empty()) text += std::string(" ") + key + "=" + Quoted(value);
  };
  add("host", config.host);
  add("port", std::to_string(config.port));
  add("dbname", config.database);
  add("user", config.user);
  add("password", config.password);
  add("sslmode", config.is_encrypted ? "verify-full" : "disable");
  if (config.is_encrypted) add("sslrootcert", config.authority);
  return text;
}

struct PostgresServer::Session {
  explicit Session(const ServerConfig& config) : connection(ConnectionText(config)) {}

  void Store(const Batch& batch);

  pqxx::connection connection;
  std::set<std::string> known;  // what it has seen to be there: days and types
};

PostgresServer::PostgresServer(ServerConfig config) : config_(std::move(config)) {
  if (config_.is_encrypted && config_.authority.empty()) {
    config_.authority = "/etc/ssl/certs/ca-certificates.crt";  // libpq 15 knows no word for it
  }
}
PostgresServer::~PostgresServer() = default;

// From its first question on a session can be aborted.
void PostgresServer::Connect() {
  if (session_ && session_->connection.is_open()) return;
  auto session = std::make_unique<Session>(config_);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    session_ = std::move(session);
  }
  pqxx::work work(session_->connection);
  MakeSchema(work);
  work.commit();
}

void PostgresServer::Disconnect() {
  const std::lock_guard<std::mutex> lock(mutex_);
  session_.reset();
}

void PostgresServer::Abort() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (session_) shutdown(session_->connection.sock(), SHUT_RDWR);
}

void PostgresServer::Session::Store(const Batch& batch) {
  std::set<std::string> made;
  pqxx::work work(connection);
  const auto is_new = [&](const std::string& key) {
    return known.count(key) == 0 && made.insert(key).second;
  };
  for (const Document& document : batch.documents) {
    const MessageType& type = *document.type;
    const std::string day = DayText(document.received);
    if (is_new(day)) MakePartition(work, day, DayText(document.received, 1));
    if (is_new(type.name + " " + type.md5)) AddType(work, type);
  }
  work.exec_params(kInsert, batch.robot, batch.spool, Rows(batch));
  if (!batch.losses.empty()) {
    work.exec_params(kInsertLosses, batch.robot, batch.spool, LossRows(batch));
  }
  work.commit();
  known.merge(made);
}

// Whether a transaction was committed whose answer was lost, nobody needs to know: it is sent
// again.
StoreResult PostgresServer::Store(const Batch& batch) {
  try {
    Connect();
    session_->Store(batch);
    return {};
  } catch (const pqxx::sql_error& error) {
    if (IsAboutTheData(error.sqlstate())) return {Answer::kRefused, FirstLine(error.what())};
    Disconnect();
    return {Answer::kAway, FirstLine(error.what())};
  } catch (const std::exception& error) {
    Disconnect();
    return {Answer::kAway, FirstLine(error.what())};
  }
}

}  // namespace coppice::robot::storage
