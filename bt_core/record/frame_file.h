// The frames of one file of a record, also of one that is damaged or still grows.
#ifndef COPPICE_BT_CORE_RECORD_FRAME_FILE_H_
#define COPPICE_BT_CORE_RECORD_FRAME_FILE_H_

#include <cstdint>
#include <string>

#include "bt_core/frames/frame.h"
#include "bt_core/record/file_window.h"

namespace coppice {

class FrameFile {
 public:
  /// Opens the file and looks at its first bytes. error() says what is wrong with it.
  explicit FrameFile(const std::string& path);

  const std::string& error() const { return error_; }

  /// A frame, and what had to be left out before it.
  struct Span {
    std::uint64_t offset = 0;
    std::uint64_t size = 0;  ///< 0: no frame is left
    std::uint8_t type = 0;
    std::uint64_t damaged = 0;  ///< bytes before `offset` that are no frame
  };

  /// The first frame at `offset` or behind it. Checks sums only where headers make no sense.
  Span Hop(std::uint64_t offset);
  /// The same; the frame is whole.
  Span Find(std::uint64_t offset);

  /// Whether its checksum is right.
  bool IsWholeAt(const Span& span);

  /// The first `count` bytes of a frame or fewer, valid until the next call; null if they cannot be
  /// read.
  const std::uint8_t* View(std::uint64_t offset, std::uint64_t count) {
    return window_.View(offset, count);
  }

  /// As far as it is known [bytes].
  std::uint64_t size() const { return window_.size(); }
  /// Looks how long the file is now.
  void Refresh() { window_.Refresh(); }

 private:
  Span HeaderAt(std::uint64_t offset);

  FileWindow window_;
  std::string error_;
  Span before_;  // what Hop found last
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_FRAME_FILE_H_
