// Reads a record from the first tick to the last whole frame, also if the file is cut off or
// damaged somewhere.
//
//   Diagnostics diagnostics;
//   auto reader = RecordReader::Open("run.coppice", diagnostics);
//   if (!reader) ...                                       // diagnostics say why
//   while (auto entry = reader->Next()) std::visit(..., *entry);
#ifndef COPPICE_BT_CORE_RECORD_RECORD_READER_H_
#define COPPICE_BT_CORE_RECORD_RECORD_READER_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/record/entries.h"
#include "bt_core/record/file_window.h"

namespace coppice {

/// A piece of the file that could not be read, and was left out.
struct RecordDamage {
  std::uint64_t offset;  ///< in the file [bytes]
  std::string what;
};

class RecordReader {
 public:
  /// Reads the header. Nothing is returned if this is no record, is one of a newer version, or its
  /// header is damaged.
  static std::optional<RecordReader> Open(const std::string& path, Diagnostics& diagnostics);

  const RecordHeader& header() const { return header_; }

  /// The next entry; nothing at the end of the file.
  std::optional<RecordEntry> Next();

  /// So far.
  const std::vector<RecordDamage>& damages() const { return damages_; }
  /// Whether the end of an orderly closed record was read.
  bool closed() const { return closed_; }

 private:
  explicit RecordReader(FileWindow file) : file_(std::move(file)) {}

  std::string ReadHeader();
  // Size of the whole frame at an offset, or 0 if there is none.
  std::uint64_t FrameAt(std::uint64_t offset);
  void SkipDamage();
  std::optional<RecordEntry> Decode(std::uint64_t frame_size);

  FileWindow file_;
  RecordHeader header_;
  std::uint64_t offset_ = 0;
  std::vector<RecordDamage> damages_;
  bool closed_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_RECORD_READER_H_
