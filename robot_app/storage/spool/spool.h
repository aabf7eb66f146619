// The spool: documents on the disk until the server has them (SQLite, write-ahead log, each commit
// waited for until it is on the disk).
//
//   Expected<std::unique_ptr<Spool>> spool = Spool::Open("spool.db", {});
//   spool->Add({document, ...});                   // all or none
//   Batch batch = spool->Next({1000, 4 << 20});    // the most important first, then the oldest
//   ... sent and committed there ...
//   spool->Remove(batch);
//
// What Add has accepted is there after a crash of the program or of the computer. When the spool is
// full, the least important documents go, the oldest of them first, and are counted.
//
// Any thread. Functions throw std::runtime_error if the file cannot be read or written (a full
// disk); then nothing has changed.
#ifndef COPPICE_ROBOT_APP_STORAGE_SPOOL_SPOOL_H_
#define COPPICE_ROBOT_APP_STORAGE_SPOOL_SPOOL_H_

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/storage/messages/document.h"

namespace SQLite {
class Database;
}

namespace coppice::robot::storage {

struct SpoolLimits {
  std::uint64_t largest = std::uint64_t{2} << 30;  ///< bytes of documents on the disk
};

struct BatchLimits {
  std::size_t documents = 1000;
  std::size_t bytes = std::size_t{4} << 20;  ///< of their JSON; a longer document goes alone
};

/// What lies in the spool.
struct Backlog {
  std::int64_t documents = 0;
  std::uint64_t bytes = 0;   ///< on the disk
  std::int64_t oldest = 0;   ///< when the oldest one was received [ns since 1970]; 0: there is none
  std::int64_t lost = 0;     ///< since the spool was made
  std::int64_t refused = 0;  ///< by the server; kept aside
};

class Spool {
 public:
  /// Makes the file if it is missing. One that SQLite finds damaged takes the name PATH.damaged,
  /// and a new one is begun. Where the disk takes nothing it is made by the first Add that can;
  /// until then all throws. A problem if it is of another program, or in use by one.
  static Expected<std::unique_ptr<Spool>> Open(const std::string& path, const SpoolLimits& limits);
  ~Spool();

  /// A random name, made with the file: a new file begins to count anew, under another name.
  std::string name() const;

  /// Whether another one was damaged, and lies beside it, or was deleted.
  bool has_replaced() const;

  /// In one transaction, with what was lost before it got here. Makes room first, if need be. If
  /// the file has been found damaged, or was deleted, a new one is begun, and what the old one held
  /// is counted as lost.
  void Add(const std::vector<Document>& documents, const std::vector<Loss>& losses = {});

  Batch Next(const BatchLimits& limits) const;
  void Remove(const Batch& batch);
  /// Puts the documents aside, because the server will never take them: Next does not give them any
  /// more. `reason` is kept with them. They are the first to go when there is no room.
  void SetAside(const Batch& batch, const std::string& reason);

  Backlog Look() const;

 private:
  Spool(std::string path, const SpoolLimits& limits);
  Outcome OpenFile();
  void Renew(std::int64_t now);
  template <class Use>
  auto Using(Use use) const;
  void AddAll(const std::vector<Document>& documents, const std::vector<Loss>& losses);
  Batch FirstOf(const BatchLimits& limits) const;
  void RemoveAll(const Batch& batch);
  void SetAllAside(const Batch& batch, const std::string& reason);
  void Prepare();
  std::uint64_t UsedBytes() const;
  std::int64_t MakeRoom(std::int64_t now);  // how many were given up
  void ForgetTypes();
  std::int64_t GiveUp(const char* query, const char* reason, std::int64_t now);
  void Count(const Loss& loss);
  std::int64_t NumberOf(const MessageType& type);
  std::shared_ptr<const MessageType> TypeOf(std::int64_t number) const;

  const std::string path_;
  const SpoolLimits limits_;
  mutable std::mutex mutex_;
  std::unique_ptr<SQLite::Database> database_;  // null: it could not be renewed
  std::pair<dev_t, ino_t> file_;                // that is open
  mutable bool is_damaged_ = false;             // as somebody has found
  std::int64_t gone_ = 0;                       // documents that are not yet counted as lost
  std::string name_;
  bool has_replaced_ = false;
  std::int64_t documents_ = 0;
  mutable std::map<std::int64_t, std::shared_ptr<const MessageType>> types_;  // that were read
};

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_SPOOL_SPOOL_H_
