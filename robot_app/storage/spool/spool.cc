#include "robot_app/storage/spool/spool.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "robot_app/storage/spool/schema.h"

namespace coppice::robot::storage {
namespace {

constexpr int kDamaged = 11;             // SQLITE_CORRUPT
constexpr int kPatience = 1000;          // ms, with another program
constexpr int kGivenUpAtOnce = 50;       // documents, when there is no room
constexpr int kFreePages = 4096;         // that are kept in the file when it has become empty
constexpr std::size_t kMostTypes = 200;  // in memory
constexpr const char* kNoRoom = "the spool was full";

Document ReadDocument(SQLite::Statement& row, std::shared_ptr<const MessageType> type) {
  return {row.getColumn(0).getInt64(), row.getColumn(1).getInt(),    row.getColumn(2).getInt64(),
          row.getColumn(3).getInt64(), row.getColumn(4).getString(), std::move(type),
          row.getColumn(6).getString()};
}

bool IsEmpty(SQLite::Database& database) {
  return database.execAndGet("PRAGMA application_id").getInt() == 0 &&
         database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
}

void Make(SQLite::Database& database) {
  database.exec("PRAGMA auto_vacuum = INCREMENTAL");  // before the first table
  database.exec("PRAGMA journal_mode = WAL");
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  database.exec(kSchema);
  database.exec("PRAGMA application_id = " + std::to_string(kApplicationId));
  database.exec("PRAGMA user_version = " + std::to_string(kSchemaVersion));
  transaction.commit();
}

// What its log holds is of the damaged file and goes with it.
bool PutAside(const std::string& path) {
  std::error_code error;
  for (const char* const part : {"-wal", "-shm", ""}) {
    std::filesystem::rename(path + part, path + ".damaged" + part, error);
  }
  return !error;
}

}  // namespace

Spool::Spool(std::unique_ptr<SQLite::Database> database, const SpoolLimits& limits)
    : limits_(limits), database_(std::move(database)) {}
Spool::~Spool() = default;

Expected<std::unique_ptr<Spool>> Spool::Open(const std::string& path, const SpoolLimits& limits) {
  try {
    return OpenWhole(path, limits);
  } catch (const SQLite::Exception& error) {
    const bool is_damaged = error.getErrorCode() == kDamaged && PutAside(path);
    if (!is_damaged) return Problem{path + ": " + error.what()};
  }
  try {
    auto spool = OpenWhole(path, limits);
    if (spool) (*spool)->has_replaced_ = true;
    return spool;
  } catch (const SQLite::Exception& error) {
    return Problem{path + ": " + error.what()};
  }
}

Expected<std::unique_ptr<Spool>> Spool::OpenWhole(const std::string& path,
                                                  const SpoolLimits& limits) {
  auto database = std::make_unique<SQLite::Database>(
      path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kPatience);
  database->exec("PRAGMA locking_mode = EXCLUSIVE");  // two writers would send everything twice
  if (IsEmpty(*database)) Make(*database);
  if (database->execAndGet("PRAGMA application_id").getInt() != kApplicationId) {
    return Problem{path + ": a database of another program"};
  }
  if (database->execAndGet("PRAGMA user_version").getInt() != kSchemaVersion) {
    return Problem{path + ": a spool of another version of Coppice; send it with that, first"};
  }
  std::unique_ptr<Spool> spool(new Spool(std::move(database), limits));
  spool->Prepare();
  return spool;
}

void Spool::Prepare() {
  database_->exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
  SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
  name_ = database_->execAndGet("SELECT name FROM spool").getString();
  documents_ = database_->execAndGet("SELECT count(*) FROM documents").getInt64();
  transaction.commit();
}

// Within a transaction.
std::int64_t Spool::NumberOf(const MessageType& type) {
  SQLite::Statement add(*database_,
                        "INSERT OR IGNORE INTO types (name, md5, definition) VALUES (?, ?, ?)");
  SQLite::bind(add, type.name, type.md5, type.definition);
  add.exec();
  SQLite::Statement find(*database_, "SELECT id FROM types WHERE name = ? AND md5 = ?");
  SQLite::bind(find, type.name, type.md5);
  find.executeStep();
  return find.getColumn(0).getInt64();
}

std::shared_ptr<const MessageType> Spool::TypeOf(std::int64_t number) const {
  if (types_.size() >= kMostTypes) types_.clear();  // they are in the file
  std::shared_ptr<const MessageType>& type = types_[number];
  if (type) return type;
  SQLite::Statement find(*database_, "SELECT name, md5, definition FROM types WHERE id = ?");
  find.bind(1, number);
  find.executeStep();
  type = std::make_shared<const MessageType>(MessageType{
      find.getColumn(0).getString(), find.getColumn(1).getString(), find.getColumn(2).getString()});
  return type;
}

void Spool::Add(const std::vector<Document>& documents, const std::vector<Loss>& losses) {
  const std::lock_guard<std::mutex> lock(mutex_);
  SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
  SQLite::Statement add(*database_,
                        "INSERT INTO documents (priority, received, stamp, topic, type, json) "
                        "VALUES (?, ?, ?, ?, ?, ?)");
  std::map<const MessageType*, std::int64_t> numbers;
  for (const Document& document : documents) {
    const auto [number, is_new] = numbers.emplace(document.type.get(), 0);
    if (is_new) number->second = NumberOf(*document.type);
    SQLite::bind(add, document.priority, document.received, document.stamp, document.topic,
                 number->second, document.json);
    add.exec();
    add.reset();
  }
  for (const Loss& loss : losses) Count(loss);
  const std::int64_t gone = MakeRoom(documents.empty() ? 0 : documents.back().received);
  transaction.commit();
  documents_ += static_cast<std::int64_t>(documents.size()) - gone;
}

std::uint64_t Spool::UsedBytes() const {
  const auto number = [this](const char* pragma) {
    return static_cast<std::uint64_t>(database_->execAndGet(pragma).getInt64());
  };
  return (number("PRAGMA page_count") - number("PRAGMA freelist_count")) *
         number("PRAGMA page_size");
}

std::int64_t Spool::MakeRoom(std::int64_t now) {
  std::int64_t gone = 0;
  while (UsedBytes() > limits_.largest) {
    SQLite::Statement least(*database_,
                            "DELETE FROM documents WHERE number IN (SELECT number FROM documents "
                            "WHERE priority = (SELECT min(priority) FROM documents) "
                            "ORDER BY number LIMIT ?) RETURNING topic");
    least.bind(1, kGivenUpAtOnce);
    std::int64_t given_up = 0;
    for (; least.executeStep(); ++given_up) {
      Count({least.getColumn(0).getString(), kNoRoom, 1, now, now});
    }
    if (given_up == 0) break;
    gone += given_up;
  }
  return gone;
}

void Spool::Count(const Loss& loss) {
  SQLite::Statement count(*database_,
                          "INSERT INTO losses VALUES (?, ?, ?, ?, ?) ON CONFLICT DO UPDATE "
                          "SET count = count + excluded.count, last = excluded.last");
  SQLite::bind(count, loss.topic, loss.reason, loss.count, loss.first, loss.last);
  count.exec();
}

Batch Spool::Next(const BatchLimits& limits) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  Batch batch;
  batch.spool = name_;
  SQLite::Statement next(*database_,
                         "SELECT number, priority, received, stamp, topic, type, json "
                         "FROM documents ORDER BY priority DESC, number LIMIT ?");
  next.bind(1, static_cast<std::int64_t>(limits.documents));
  std::size_t bytes = 0;
  while (next.executeStep()) {
    Document document = ReadDocument(next, TypeOf(next.getColumn(5).getInt64()));
    bytes += document.json.size();
    if (bytes > limits.bytes && !batch.documents.empty()) break;
    batch.documents.push_back(std::move(document));
  }
  SQLite::Statement loss(*database_, "SELECT topic, reason, count, first, last FROM losses");
  while (loss.executeStep()) {
    batch.losses.push_back({loss.getColumn(0).getString(), loss.getColumn(1).getString(),
                            loss.getColumn(2).getInt64(), loss.getColumn(3).getInt64(),
                            loss.getColumn(4).getInt64()});
  }
  return batch;
}

void Spool::Remove(const Batch& batch) {
  const std::lock_guard<std::mutex> lock(mutex_);
  SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
  SQLite::Statement remove(*database_, "DELETE FROM documents WHERE number = ?");
  for (const Document& document : batch.documents) {
    remove.bind(1, document.number);
    remove.exec();
    remove.reset();
  }
  transaction.commit();
  documents_ -= static_cast<std::int64_t>(batch.documents.size());
  if (database_->execAndGet("PRAGMA freelist_count").getInt64() > kFreePages) {
    database_->exec("PRAGMA incremental_vacuum(" + std::to_string(kFreePages / 2) + ")");
  }
}

void Spool::SetAside(const Batch& batch, const std::string& reason) {
  const std::lock_guard<std::mutex> lock(mutex_);
  SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
  SQLite::Statement keep(*database_,
                         "INSERT INTO refused SELECT number, received, stamp, topic, type, json, ? "
                         "FROM documents WHERE number = ?");
  SQLite::Statement remove(*database_, "DELETE FROM documents WHERE number = ?");
  for (const Document& document : batch.documents) {
    SQLite::bind(keep, reason, document.number);
    keep.exec();
    keep.reset();
    remove.bind(1, document.number);
    remove.exec();
    remove.reset();
  }
  transaction.commit();
  documents_ -= static_cast<std::int64_t>(batch.documents.size());
}

Backlog Spool::Look() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto number = [this](const char* query) { return database_->execAndGet(query).getInt64(); };
  return {documents_, UsedBytes(),
          number("SELECT coalesce((SELECT received FROM documents ORDER BY number LIMIT 1), 0)"),
          number("SELECT coalesce(sum(count), 0) FROM losses"),
          number("SELECT count(*) FROM refused")};
}

}  // namespace coppice::robot::storage
