// What is too large for a document, kept on the robot: a file for each array, in a folder for each
// day. When they take too much room, the oldest ones go.
#ifndef COPPICE_ROBOT_APP_STORAGE_TOPICS_FILE_STORE_H_
#define COPPICE_ROBOT_APP_STORAGE_TOPICS_FILE_STORE_H_

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace coppice::robot::storage {

/// Any thread.
class FileStore {
 public:
  /// Takes over what is in the folder already.
  FileStore(std::string folder, std::uint64_t largest);

  /// The name under which a document finds it: "2026-11-25/081500.123456-1.bin". Empty if it could
  /// not be written.
  std::string Keep(std::string_view bytes, std::int64_t now);

  std::uint64_t bytes() const;

 private:
  struct Kept {
    std::string name;
    std::uint64_t bytes = 0;
  };
  void MakeRoom();

  const std::string folder_;
  const std::uint64_t largest_;
  mutable std::mutex mutex_;
  std::deque<Kept> kept_;  // the oldest first
  std::uint64_t bytes_ = 0;
  std::uint64_t count_ = 0;
};

/// What a document names. Nothing if it is not there any more, or if the name leads out of the
/// folder.
std::optional<std::string> ReadKeptFile(const std::string& folder, const std::string& name);

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_TOPICS_FILE_STORE_H_
