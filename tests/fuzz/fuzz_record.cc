#include <algorithm>
#include <vector>

#include "bt_core/record/record_cursor.h"
#include "tests/fuzz/frames.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/history_check.h"
#include "tests/support/temporary_folder.h"

namespace coppice::fuzz {
namespace {

// Types of frames that are none.
constexpr unsigned char kAsItIs = 0xf0;    // the payload is written as it is
constexpr unsigned char kCut = 0xf1;       // so many bytes at the end are taken away
constexpr unsigned char kNextFile = 0xf2;  // the series goes on in another file
constexpr unsigned char kLook = 0xf3;      // a reader opens the record and refreshes it later
constexpr std::size_t kMostFiles = 4;

struct Record {
  std::vector<std::string> files;
  std::size_t looked_file = 0;  // where a reader has looked first, and how long it was
  std::size_t looked_size = 0;
};

std::string Preamble() {
  Bytes bytes;
  AppendPreamble(bytes);
  return {bytes.begin(), bytes.end()};
}

Record MakeRecord(std::string_view bytes) {
  Record record;
  record.files.push_back(Preamble());
  Packer packer;
  for (LooseFrame frame; TakeFrame(bytes, frame);) {
    std::string& file = record.files.back();
    if (frame.type == kAsItIs) {
      file += frame.payload;
    } else if (frame.type == kCut) {
      file.resize(file.size() - std::min(file.size(), frame.payload.size()));
    } else if (frame.type == kNextFile) {
      if (record.files.size() < kMostFiles) record.files.push_back(Preamble());
    } else if (frame.type == kLook) {
      record.looked_file = record.files.size() - 1;
      record.looked_size = file.size();
    } else {
      const Bytes sealed = Seal(frame, packer);
      file.append(sealed.begin(), sealed.end());
    }
  }
  return record;
}

std::string NameOf(const TemporaryFolder& folder, std::size_t file) {
  return folder.Path(file == 0 ? "run.coppice" : "run." + std::to_string(file + 1) + ".coppice");
}

void CheckIndex(const RecordReader& record) {
  Require(!record.trees().empty() && !record.files().empty() && !record.keyframes().empty());
  for (const RecordKeyframe& keyframe : record.keyframes()) {
    Require(keyframe.file < record.files().size() && keyframe.tree < record.trees().size());
  }
  for (const RecordDamage& damage : record.damages()) Require(damage.file < record.files().size());
}

void CheckPlace(const RecordCursor& cursor) {
  const HistoryFollower& state = cursor.state();
  Require(state.statuses().size() == cursor.tree().nodes.size());
  Require(state.values().size() == cursor.tree().slots.size());
  Require(state.last(kRootNode) <= Status::kSkipped);
}

// Reads it from the beginning to the end; returns how far it comes, as FuzzRecord does.
int ReadOn(RecordCursor& cursor) {
  HistoryCheck check;
  check.OnTree(cursor.tree());
  check.OnState(cursor.state().State(HistoryState::Cause::kBegin));
  for (RecordItem item = cursor.Next(); item != RecordItem::kNone; item = cursor.Next()) {
    CheckPlace(cursor);
    if (item == RecordItem::kTree) check.OnTree(cursor.tree());
    if (item == RecordItem::kTree || item == RecordItem::kState) {
      check.OnState(cursor.state().State(HistoryState::Cause::kBegin));
    }
    if (item == RecordItem::kTick) check.OnTick(cursor.events());
  }
  return check.reached() == 3 ? 2 : 1;
}

void SeekAround(const RecordReader& record) {
  RecordCursor cursor(record);
  for (const std::uint64_t tick :
       {record.first_tick(), record.last_tick(), record.first_tick() / 2 + record.last_tick() / 2,
        std::uint64_t{0}, UINT64_MAX}) {
    cursor.SeekTick(tick);
    CheckPlace(cursor);
    cursor.Next();
    CheckPlace(cursor);
  }
  for (const Time time : {record.begin(), record.end(), Time::min(), Time::max()}) {
    cursor.SeekTime(time);
    CheckPlace(cursor);
  }
  cursor.SeekLast();
  CheckPlace(cursor);
  Require(cursor.state().tick() == record.last_tick());
  cursor.SeekBegin();
  CheckPlace(cursor);
}

}  // namespace

int FuzzRecord(std::string_view bytes) {
  static const TemporaryFolder folder;
  const Record written = MakeRecord(bytes);
  std::unique_ptr<RecordReader> early;
  for (std::size_t i = 0; i < kMostFiles; ++i) {
    std::filesystem::remove(NameOf(folder, i));
  }
  for (std::size_t i = 0; i < written.files.size(); ++i) {
    if (i == written.looked_file && written.looked_size > 0) {
      WriteFile(NameOf(folder, i), written.files[i].substr(0, written.looked_size));
      Diagnostics ignored;
      early = RecordReader::Open(NameOf(folder, 0), ignored);
    }
    WriteFile(NameOf(folder, i), written.files[i]);
  }
  if (early) {
    early->Refresh();
    CheckIndex(*early);
    SeekAround(*early);
  }
  Diagnostics diagnostics;
  const auto record = RecordReader::Open(NameOf(folder, 0), diagnostics);
  Require((record == nullptr) == diagnostics.has_errors());
  if (!record) return 0;
  CheckIndex(*record);
  SeekAround(*record);
  RecordCursor cursor(*record);
  CheckPlace(cursor);
  return ReadOn(cursor);
}

}  // namespace coppice::fuzz
