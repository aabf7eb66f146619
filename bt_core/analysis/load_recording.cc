#include "bt_core/analysis/load_recording.h"

#include <memory>
#include <vector>

#include "bt_core/record/record_cursor.h"

namespace coppice {
namespace {

// Reads a record to its end.
class Loader {
 public:
  Loader(const RecordReader& record, Recording& out) : cursor_(record), out_(out) {}

  std::vector<RecordDamage> Load() {
    tree_ = &cursor_.tree();
    out_.OnTree(*tree_);
    out_.OnState(cursor_.state().State(HistoryState::Cause::kBegin));
    while (Take(cursor_.Next())) {
    }
    return cursor_.damages();
  }

 private:
  bool Take(RecordItem item) {
    switch (item) {
      case RecordItem::kTick:
        TakeTick(cursor_.events());
        return true;
      case RecordItem::kTree:
        is_other_tree_ = &cursor_.tree() != tree_;
        tree_ = &cursor_.tree();
        if (is_other_tree_) out_.OnTree(*tree_);
        return true;
      case RecordItem::kState:
        out_.OnState(cursor_.state().State(is_lost_ ? HistoryState::Cause::kLost
                                                    : HistoryState::Cause::kJump));
        is_lost_ = false;
        return true;
      case RecordItem::kGap:
        is_lost_ = true;
        out_.OnGap(cursor_.gap());
        return true;
      case RecordItem::kDamage:
        is_lost_ = true;
        return true;
      case RecordItem::kNote:
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
    out_.OnTick(events);
  }

  RecordCursor cursor_;
  Recording& out_;
  const TreeDescription* tree_ = nullptr;
  bool is_other_tree_ = false;
  bool is_lost_ = false;
  std::uint64_t part_of_ = 0;  // number of the tick that is not whole yet
  std::size_t known_words_ = 0;
};

}  // namespace

std::optional<Recording> LoadRecording(const std::string& path, Diagnostics& diagnostics) {
  const std::unique_ptr<RecordReader> record = RecordReader::Open(path, diagnostics);
  if (!record) return std::nullopt;
  Recording run;
  for (const RecordDamage& damage : Loader(*record, run).Load()) {
    run.OnDamage();
    diagnostics.Warning({record->files()[damage.file]},
                        "damaged at byte " + std::to_string(damage.offset) + ": " + damage.what);
  }
  return run;
}

}  // namespace coppice
