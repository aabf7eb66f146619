#include "robot_app/storage/spool/spool.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <sys/stat.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "robot_app/common/databases/open_database.h"
#include "robot_app/storage/spool/schema.h"

namespace coppice::robot::storage {
namespace {

constexpr int kDamaged = 11, kNoDatabase = 26;  // SQLITE_CORRUPT, SQLITE_NOTADB
constexpr int kLongestDocument = 16 << 20;      // bytes; none is longer than 4 MB
constexpr int kPatience = 1000;                 // ms, with another program
constexpr int kGivenUpAtOnce = 50;              // documents, when there is no room
constexpr int kFreePages = 4096;  // that are kept in the file when it has become empty
constexpr int kMostTypes = 200;   // in memory, and in a full spool of which it holds nothing
constexpr const char* kNoRoom = "the spool was full";
constexpr const char* kRefusedNoRoom = "the server had refused it, and the spool was full";
constexpr const char* kDeleted = "the spool was deleted";
constexpr const char* kWasDamaged = "the spool was damaged";
constexpr const char* kAllTopics = "all topics";

constexpr const char* kOldestRefused =
    "DELETE FROM refused WHERE number IN (SELECT number FROM refused ORDER BY number LIMIT ?) "
    "RETURNING topic";
constexpr const char* kLeastImportant =
    "DELETE FROM documents WHERE number IN (SELECT number FROM documents "
    "WHERE priority = (SELECT min(priority) FROM documents) ORDER BY number LIMIT ?) "
    "RETURNING topic";

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

// Zeros if there is none.
std::pair<dev_t, ino_t> FileAt(const std::string& path) {
  struct stat file {};
  if (stat(path.c_str(), &file) != 0) return {};
  return {file.st_dev, file.st_ino};
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

Spool::Spool(std::string path, const SpoolLimits& limits)
    : path_(std::move(path)), limits_(limits) {}
Spool::~Spool() = default;

Expected<std::unique_ptr<Spool>> Spool::Open(const std::string& path, const SpoolLimits& limits) {
  std::unique_ptr<Spool> spool(new Spool(path, limits));
  Outcome opened;
  try {
    opened = spool->OpenFile();
  } catch (const SQLite::Exception& error) {
    spool->database_.reset();
    if (IsOfTheDisk(error)) return spool;  // Add tries it again
    const bool is_damaged = error.getErrorCode() == kDamaged && PutAside(path);
    if (!is_damaged) return Problem{path + ": " + error.what()};
    spool->has_replaced_ = true;
  }
  try {
    if (spool->has_replaced_) opened = spool->OpenFile();
  } catch (const SQLite::Exception& error) {
    return Problem{path + ": " + error.what()};
  }
  if (!opened) return Problem{opened.problem()};
  return spool;
}

Outcome Spool::OpenFile() {
  database_ = OpenDatabase(path_, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kPatience,
                           kLongestDocument);
  database_->exec("PRAGMA locking_mode = EXCLUSIVE");  // two writers would send everything twice
  if (IsEmpty(*database_)) Make(*database_);
  if (database_->execAndGet("PRAGMA application_id").getInt() != kApplicationId) {
    return Problem{path_ + ": a database of another program"};
  }
  if (database_->execAndGet("PRAGMA user_version").getInt() != kSchemaVersion) {
    return Problem{path_ + ": a spool of another version of Coppice; send it with that, first"};
  }
  Prepare();
  file_ = FileAt(path_);
  return {};
}

// A file that was deleted takes all that is written into it along.
void Spool::Renew(std::int64_t now) {
  const bool is_deleted = FileAt(path_) != file_;
  gone_ += std::exchange(documents_, 0);
  database_.reset();
  types_.clear();
  if (!is_deleted) PutAside(path_);
  std::error_code error;  // opening says it
  std::filesystem::create_directories(std::filesystem::path(path_).parent_path(), error);
  try {
    const Outcome opened = OpenFile();
    if (!opened) throw std::runtime_error(opened.problem());
    has_replaced_ = true;
    const char* const why = is_deleted ? kDeleted : kWasDamaged;
    if (gone_ > 0) Count({kAllTopics, why, std::exchange(gone_, 0), now, now});
    is_damaged_ = false;
  } catch (const std::runtime_error&) {
    database_.reset();
    throw;
  }
}

// Whatever finds the file damaged, the next Add begins a new one.
template <class Use>
auto Spool::Using(Use use) const {
  if (!database_) throw std::runtime_error(path_ + ": cannot be opened");
  try {
    return use();
  } catch (const SQLite::Exception& error) {
    is_damaged_ |= error.getErrorCode() == kDamaged || error.getErrorCode() == kNoDatabase;
    throw;
  }
}

std::string Spool::name() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return name_;
}

bool Spool::has_replaced() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return has_replaced_;
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
  if (static_cast<int>(types_.size()) >= kMostTypes) types_.clear();  // they are in the file
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
  const std::int64_t now = !documents.empty() ? documents.back().received
                           : !losses.empty()  ? losses.back().last
                                              : 0;
  if (!database_ || is_damaged_ || FileAt(path_) != file_) Renew(now);
  try {
    Using([&] { AddAll(documents, losses); });
  } catch (const SQLite::Exception&) {
    if (!is_damaged_) throw;
    Renew(now);
    AddAll(documents, losses);
  }
}

void Spool::AddAll(const std::vector<Document>& documents, const std::vector<Loss>& losses) {
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

// First what the server will never take, or all that comes later would have to go for it.
std::int64_t Spool::MakeRoom(std::int64_t now) {
  if (UsedBytes() > limits_.largest) ForgetTypes();
  std::int64_t gone = 0;
  while (UsedBytes() > limits_.largest) {
    if (GiveUp(kOldestRefused, kRefusedNoRoom, now) > 0) continue;
    const std::int64_t given_up = GiveUp(kLeastImportant, kNoRoom, now);
    if (given_up == 0) break;
    gone += given_up;
  }
  return gone;
}

// More of them than a robot has; looking for those of which there is no document takes long.
void Spool::ForgetTypes() {
  if (database_->execAndGet("SELECT count(*) FROM types").getInt64() <= kMostTypes) return;
  types_.clear();
  database_->exec(
      "DELETE FROM types WHERE id NOT IN (SELECT type FROM documents UNION SELECT type FROM "
      "refused)");
}

std::int64_t Spool::GiveUp(const char* query, const char* reason, std::int64_t now) {
  SQLite::Statement least(*database_, query);
  least.bind(1, kGivenUpAtOnce);
  std::int64_t given_up = 0;
  for (; least.executeStep(); ++given_up) {
    Count({least.getColumn(0).getString(), reason, 1, now, now});
  }
  return given_up;
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
  return Using([&] { return FirstOf(limits); });
}

Batch Spool::FirstOf(const BatchLimits& limits) const {
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

// Of a spool that has been renewed meanwhile nothing is here any more.
void Spool::Remove(const Batch& batch) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (batch.spool == name_) Using([&] { RemoveAll(batch); });
}

void Spool::RemoveAll(const Batch& batch) {
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
  if (batch.spool == name_) Using([&] { SetAllAside(batch, reason); });
}

void Spool::SetAllAside(const Batch& batch, const std::string& reason) {
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
  return Using([&] {
    return Backlog{
        documents_, UsedBytes(),
        number("SELECT coalesce((SELECT received FROM documents ORDER BY number LIMIT 1), 0)"),
        number("SELECT coalesce(sum(count), 0) FROM losses"),
        number("SELECT count(*) FROM refused")};
  });
}

}  // namespace coppice::robot::storage
