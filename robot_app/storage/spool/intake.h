// Documents on their way into the spool: whoever hears a message does not wait for the disk. A
// thread of its own commits what has come, several times a second.
//
// While the spool cannot be written (a full disk), documents wait in memory; when that is full, the
// least important ones go, the oldest first, and are counted. What is here when the power goes is
// lost: the last tenth of a second.
#ifndef COPPICE_ROBOT_APP_STORAGE_SPOOL_INTAKE_H_
#define COPPICE_ROBOT_APP_STORAGE_SPOOL_INTAKE_H_

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/storage/messages/document.h"
#include "robot_app/storage/spool/spool.h"

namespace coppice::robot::storage {

struct IntakeLimits {
  std::size_t largest = std::size_t{64} << 20;       ///< bytes of JSON in memory
  Duration period = std::chrono::milliseconds(100);  ///< from commit to commit
};

struct IntakeState {
  std::uint64_t stored = 0;   ///< documents, since the start
  std::size_t documents = 0;  ///< that wait
  std::uint64_t lost = 0;     ///< since the start; also those that Lose was told of
  std::uint64_t rounds = 0;   ///< how often it has looked for work: it lives if that grows
  std::string problem;        ///< why the spool could not be written the last time, or empty
};

class Intake {
 public:
  /// `on_stored` is called by its thread after each commit. The spool must live longer.
  Intake(Spool& spool, const IntakeLimits& limits, std::function<void()> on_stored);
  /// Stores what is there, if that can be.
  ~Intake();

  /// Any thread; never waits for the disk.
  void Put(Document document);
  /// Counts a message that became no document. Any thread.
  void Lose(const std::string& topic, const std::string& reason, std::int64_t now);

  IntakeState Look() const;

 private:
  static constexpr std::size_t kPriorities = 10;

  void Run();
  void Commit();
  void Append(Document document);
  void MakeRoom(std::int64_t now);
  void CountLoss(const std::string& topic, const std::string& reason, std::int64_t now);
  std::string Reason(const std::string& topic, const std::string& reason);
  std::vector<Document> TakeDocuments();
  std::vector<Loss> TakeLosses();
  void PutBack(std::vector<Document> documents, std::vector<Loss> losses, const char* problem);

  Spool& spool_;
  const IntakeLimits limits_;
  const std::function<void()> on_stored_;

  mutable std::mutex mutex_;  // of what is below
  std::condition_variable end_;
  std::array<std::deque<Document>, kPriorities> waiting_;
  std::size_t bytes_ = 0;  // of them
  std::map<std::pair<std::string, std::string>, Loss> losses_;
  std::map<std::string, std::set<std::string>> reasons_;  // of each topic, since the start
  IntakeState state_;
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_SPOOL_INTAKE_H_
