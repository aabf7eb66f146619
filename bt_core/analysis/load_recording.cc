#include "bt_core/analysis/load_recording.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "bt_core/frames/history_size.h"
#include "bt_core/record/record_cursor.h"

namespace coppice {
namespace {

// Reads a record to its end.
class Loader {
 public:
  Loader(const RecordReader& record, Recording& out, std::size_t most_bytes)
      : cursor_(record), out_(out), most_bytes_(most_bytes) {}

  /// Nothing if it is too long.
  std::optional<std::vector<RecordDamage>> Load() {
    tree_ = &cursor_.tree();
    TakeTree();
    TakeState(HistoryState::Cause::kBegin);
    while (Take(cursor_.Next())) {
      if (bytes_ > most_bytes_) return std::nullopt;
    }
    return cursor_.damages();
  }

 private:
  // What grows has room for as much again.
  static constexpr std::size_t kRoom = 2;

  void TakeTree() {
    bytes_ += BytesOf(*tree_);
    out_.OnTree(*tree_);
  }

  void TakeState(HistoryState::Cause cause) {
    const HistoryState state = cursor_.state().State(cause);
    bytes_ += BytesOf(state);
    out_.OnState(state);
  }

  bool Take(RecordItem item) {
    switch (item) {
      case RecordItem::kTick:
        TakeTick(cursor_.events());
        return true;
      case RecordItem::kTree:
        is_other_tree_ = &cursor_.tree() != tree_;
        tree_ = &cursor_.tree();
        if (is_other_tree_) TakeTree();
        return true;
      case RecordItem::kState:
        TakeState(is_lost_ ? HistoryState::Cause::kLost : HistoryState::Cause::kJump);
        is_lost_ = false;
        return true;
      case RecordItem::kGap:
        is_lost_ = true;
        bytes_ += sizeof(HistoryGap);
        out_.OnGap(cursor_.gap());
        return true;
      case RecordItem::kDamage:
        bytes_ += sizeof(RecordDamage);
        is_lost_ = true;
        return true;
      case RecordItem::kNote:
        bytes_ += BytesOf(cursor_.note());
        out_.OnNote(cursor_.note());
        return true;
      case RecordItem::kEnd:
        out_.OnEnd(cursor_.end());
        return true;
      case RecordItem::kNone:
        return false;
    }
    return false;
  }

  // Parts of a tick bring what was before: only the rest is new.
  void TakeTick(TickEvents events) {
    const std::size_t known = events.tick == part_of_ ? known_words_ : 0;
    known_words_ = events.words.size;
    part_of_ = events.is_whole ? 0 : events.tick;
    events.words.data += known;
    events.words.size -= known;
    bytes_ += kRoom * (sizeof(Recording::Tick) + events.words.size * sizeof(std::uint32_t));
    out_.OnTick(events);
  }

  RecordCursor cursor_;
  Recording& out_;
  const std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  const TreeDescription* tree_ = nullptr;
  bool is_other_tree_ = false;
  bool is_lost_ = false;
  std::uint64_t part_of_ = 0;  // number of the tick that is not whole yet
  std::size_t known_words_ = 0;
};

}  // namespace

std::size_t MostRunBytes(const RecordReader& record) {
  constexpr std::uint64_t kOfAny = std::uint64_t{128} << 20;
  constexpr std::uint64_t kTimesItsFiles = 256;
  constexpr std::uint64_t kRest = kMostRunBytes - kOfAny;
  return kOfAny + kTimesItsFiles * std::min(record.size(), kRest / kTimesItsFiles);
}

std::optional<Recording> LoadRecording(const std::string& path, Diagnostics& diagnostics,
                                       std::optional<std::size_t> most_bytes) {
  const std::unique_ptr<RecordReader> record = RecordReader::Open(path, diagnostics);
  if (!record) return std::nullopt;
  Recording run;
  const std::size_t most = most_bytes.value_or(MostRunBytes(*record));
  const auto damages = Loader(*record, run, most).Load();
  if (!damages) {
    diagnostics.Error({path},
                      "the run takes more than " + std::to_string(most >> 20) + " MiB of memory",
                      "--memory allows more");
    return std::nullopt;
  }
  for (const RecordDamage& damage : *damages) {
    run.OnDamage();
    diagnostics.Warning({record->files()[damage.file]},
                        "damaged at byte " + std::to_string(damage.offset) + ": " + damage.what);
  }
  return run;
}

}  // namespace coppice
