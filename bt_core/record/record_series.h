// The files that a record grows in, one after another.
#ifndef COPPICE_BT_CORE_RECORD_RECORD_SERIES_H_
#define COPPICE_BT_CORE_RECORD_RECORD_SERIES_H_

#include <cstdint>
#include <deque>
#include <memory>
#include <string>

#include "bt_core/base/outcome.h"
#include "bt_core/record/record_file.h"

namespace coppice {

class RecordSeries {
 public:
  /// Makes the first file, with the bytes that every file begins with. Of `keep` files the oldest
  /// is removed for another one; 0: all are kept. Throws std::runtime_error.
  RecordSeries(std::string path, std::uint32_t keep);

  /// Goes on in another file, or in the old one if none can be made. The folder of a file that
  /// was deleted is made again.
  Outcome Next();

  /// As RecordFile.
  Outcome Write(Bytes& bytes) { return file_->Write(bytes); }
  Outcome Sync() { return file_->Sync(); }
  bool is_deleted() const { return file_->is_deleted(); }

 private:
  void Open(const std::string& path);

  const std::string path_;
  const std::uint32_t keep_;
  std::uint32_t number_ = 1;  // of the present file
  std::unique_ptr<RecordFile> file_;
  std::deque<std::string> written_;  // of this series, the present file last
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_RECORD_SERIES_H_
