#include "bt_core/record/record_series.h"

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "bt_core/frames/frame.h"
#include "bt_core/record/record_names.h"

namespace coppice {

RecordSeries::RecordSeries(std::string path, std::uint32_t keep)
    : path_(std::move(path)), keep_(keep) {
  Open(path_);
}

void RecordSeries::Open(const std::string& path) {
  auto file = std::make_unique<RecordFile>(path);
  Bytes preamble;
  AppendPreamble(preamble);
  const Outcome begun = file->Write(preamble);
  if (!begun) throw std::runtime_error(begun.problem());
  file_ = std::move(file);
  written_.push_back(path);
}

// Names that are taken, for example by an older record, are left out.
Outcome RecordSeries::Next() {
  Outcome done = file_->Sync();
  std::error_code ignored;
  do {
    ++number_;
  } while (std::filesystem::exists(NumberedName(path_, number_), ignored));
  const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
  if (file_->is_deleted()) std::filesystem::create_directories(folder, ignored);
  try {
    Open(NumberedName(path_, number_));
  } catch (const std::runtime_error& problem) {
    done = Problem{problem.what()};
  }
  while (keep_ > 0 && written_.size() > keep_) {
    std::filesystem::remove(written_.front(), ignored);
    written_.pop_front();
  }
  return done;
}

}  // namespace coppice
