// Everything that is in a record.
#ifndef COPPICE_TESTS_BT_CORE_RECORD_WHOLE_RECORD_H_
#define COPPICE_TESTS_BT_CORE_RECORD_WHOLE_RECORD_H_

#include <stdexcept>
#include <string>
#include <vector>

#include "bt_core/record/record_cursor.h"
#include "tests/bt_core/frames/kept_history.h"

namespace coppice {

struct WholeRecord {
  std::vector<std::string> ticks;  ///< as texts
  std::vector<std::uint64_t> numbers;
  std::vector<HistoryNote> notes;
  std::vector<HistoryGap> gaps;
  std::vector<RecordDamage> damages;
  std::uint64_t torn_bytes = 0;
  bool closed = false;
};

inline WholeRecord ReadAll(const RecordReader& reader) {
  WholeRecord all;
  RecordCursor cursor(reader);
  for (RecordItem item = cursor.Next(); item != RecordItem::kNone; item = cursor.Next()) {
    if (item == RecordItem::kTick) {
      all.ticks.push_back(Describe(cursor.events()));
      all.numbers.push_back(cursor.events().tick);
    }
    if (item == RecordItem::kNote) all.notes.push_back(cursor.note());
    if (item == RecordItem::kGap) all.gaps.push_back(cursor.gap());
  }
  all.damages = cursor.damages();
  all.torn_bytes = reader.torn_bytes();
  all.closed = reader.closed();
  return all;
}

inline std::unique_ptr<RecordReader> OpenRecord(const std::string& path) {
  Diagnostics diagnostics;
  auto reader = RecordReader::Open(path, diagnostics);
  if (!reader) throw std::runtime_error(diagnostics.ToString());
  return reader;
}

inline WholeRecord ReadRecord(const std::string& path) { return ReadAll(*OpenRecord(path)); }

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_RECORD_WHOLE_RECORD_H_
