// A record on the disk: one file, or the series of files that a Recorder made one after another.
// Knows where reading can begin; RecordCursor (record_cursor.h) reads.
//
//   Diagnostics diagnostics;
//   auto record = RecordReader::Open("run.coppice", diagnostics);
//   if (!record) ...                                       // diagnostics say why
//   RecordCursor cursor(*record);
//   cursor.SeekTick(4711);
//
// Opening hops from frame to frame and reads little of each. A file that is cut off or damaged is
// read as far as it makes sense, and on behind the damage.
#ifndef COPPICE_BT_CORE_RECORD_RECORD_READER_H_
#define COPPICE_BT_CORE_RECORD_RECORD_READER_H_

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/base/outcome.h"
#include "bt_core/frames/history.h"
#include "bt_core/record/frame_file.h"

namespace coppice {

/// Where a state lies.
struct RecordKeyframe {
  std::uint32_t file;    ///< of RecordReader::files()
  std::uint32_t tree;    ///< of RecordReader::trees()
  std::uint64_t offset;  ///< in the file [bytes]
  std::uint64_t tick;    ///< number of the last tick before it
  Time time;             ///< and its start
};

/// A piece of a file that could not be read, and was left out.
struct RecordDamage {
  std::uint32_t file;    ///< of RecordReader::files()
  std::uint64_t offset;  ///< in the file [bytes]
  std::string what;
};

class RecordReader {
 public:
  /// With any file of a series, all of it is opened that is in the same folder. Nothing is returned
  /// if this is no record, is one of another version, or has no whole tree with a state behind it.
  static std::unique_ptr<RecordReader> Open(const std::string& path, Diagnostics& diagnostics);

  /// The tree at the start.
  const TreeDescription& tree() const { return trees_.front(); }
  /// The same, and what it was changed for since. A description that is repeated is one.
  const std::vector<TreeDescription>& trees() const { return trees_; }

  const std::vector<std::string>& files() const { return files_; }
  /// Of all files, as far as they are whole [bytes].
  std::uint64_t size() const;
  /// In the order of files and offsets. There is at least one.
  const std::vector<RecordKeyframe>& keyframes() const { return keyframes_; }

  /// What is missing because the recorder could not follow.
  const std::vector<HistoryGap>& gaps() const { return gaps_; }
  /// What the application noted, in the order of the record.
  const std::vector<HistoryNote>& notes() const { return notes_; }

  /// State at the start, and last tick.
  std::uint64_t first_tick() const { return keyframes_.front().tick; }
  Time begin() const { return keyframes_.front().time; }
  std::uint64_t last_tick() const { return last_tick_; }
  Time end() const { return end_; }

  /// Takes in what was appended since, also further files. True if there was something.
  bool Refresh();

  /// Whether the recording was closed in order. If not, it ended abruptly, or still goes on.
  bool closed() const { return closed_; }
  /// Bytes at the end that are no whole frame.
  std::uint64_t torn_bytes() const { return torn_bytes_; }
  /// Pieces that opening had to leave out. A RecordCursor looks closer.
  const std::vector<RecordDamage>& damages() const { return damages_; }

 private:
  friend class RecordCursor;
  struct TreePlace {
    std::uint32_t file;
    std::uint64_t offset;
    std::uint32_t tree;
  };
  static constexpr std::uint32_t kNoTree = UINT32_MAX;

  RecordReader() = default;
  Outcome OpenSeries(const std::string& path);
  bool OpenNext();
  bool Index();
  bool IndexFrame(const FrameFile::Span& span);
  bool IndexTree(const FrameFile::Span& span);
  bool IndexState(const FrameFile::Span& span);
  bool IndexEnd(const std::optional<HistoryEnd>& end);
  void AddDamage(std::uint64_t offset, std::uint64_t bytes);
  void FindEnd();
  void FindNewFiles();
  std::uint32_t file_number() const { return static_cast<std::uint32_t>(files_.size() - 1); }

  // For cursors: how far a file is known, and which tree is described at a place.
  std::uint64_t SizeOf(std::uint32_t file) const { return sizes_[file]; }
  std::uint32_t TreeAt(std::uint32_t file, std::uint64_t offset) const;

  std::vector<std::string> files_;
  std::vector<std::uint64_t> sizes_;  // of the files, as far as they are whole
  std::deque<std::string> waiting_;   // files that are still to be opened
  std::vector<TreeDescription> trees_;
  std::uint32_t tree_sum_ = 0;  // checksum of the last one
  std::vector<TreePlace> tree_places_;
  std::vector<RecordKeyframe> keyframes_;
  std::vector<HistoryGap> gaps_;
  std::vector<HistoryNote> notes_;
  std::vector<RecordDamage> damages_;
  std::unique_ptr<FrameFile> file_;  // the last one
  std::uint64_t offset_ = 0;         // in it
  std::uint64_t torn_bytes_ = 0;
  std::uint64_t last_tick_ = 0;
  Time end_{};
  bool continues_ = false;  // in another file
  bool closed_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_RECORD_READER_H_
