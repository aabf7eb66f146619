// Reads a file of any size piece by piece.
#ifndef COPPICE_BT_CORE_RECORD_FILE_WINDOW_H_
#define COPPICE_BT_CORE_RECORD_FILE_WINDOW_H_

#include <cstdint>
#include <string>

#include "bt_core/frames/coding.h"

namespace coppice {

class FileWindow {
 public:
  /// Opens the file. If it cannot be read, error() says why and its size is 0.
  explicit FileWindow(const std::string& path);
  ~FileWindow();
  FileWindow(FileWindow&& other) noexcept;
  FileWindow& operator=(FileWindow&&) = delete;

  /// `count` bytes from `offset` on, valid until the next call; null if they are not all there.
  const std::uint8_t* View(std::uint64_t offset, std::uint64_t count);

  /// When it was opened or refreshed [bytes].
  std::uint64_t size() const { return size_; }
  /// Looks how long the file is now.
  void Refresh();
  const std::string& error() const { return error_; }

 private:
  bool Load(std::uint64_t offset, std::uint64_t count);

  int file_ = -1;
  std::uint64_t size_ = 0;
  std::string error_;
  std::uint64_t start_ = 0;  // of the window in the file
  Bytes window_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_FILE_WINDOW_H_
