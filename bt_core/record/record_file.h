// The file that a record grows in. Only ever appended to.
#ifndef COPPICE_BT_CORE_RECORD_RECORD_FILE_H_
#define COPPICE_BT_CORE_RECORD_RECORD_FILE_H_

#include <string>

#include "bt_core/base/outcome.h"
#include "bt_core/frames/coding.h"

namespace coppice {

class RecordFile {
 public:
  /// Creates the file, or opens a pipe that somebody reads. Throws std::runtime_error if that is
  /// not possible, and for a file with something in it (a record is never overwritten) or that
  /// another RecordFile, of whatever program, is about to write; a folder, a device. Never waits.
  explicit RecordFile(std::string path);
  ~RecordFile();
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  /// Hands the bytes to the kernel and takes what was written out of `bytes`; what is left can be
  /// tried again.
  Outcome Write(Bytes& bytes);

  /// Waits until what was written is on the disk, and the file's name too.
  Outcome Sync();
  /// As the last Sync found it.
  bool is_deleted() const { return is_deleted_; }

 private:
  void BecomeOnlyOne() const;
  void SyncFolder();

  std::string path_;
  int file_;
  bool has_name_ = false;  // on the disk
  bool is_deleted_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_RECORD_FILE_H_
