// A place in a record: how the tree stands there, and what has just happened.
//
//   RecordCursor cursor(record);
//   cursor.SeekTime(cursor.record().begin() + std::chrono::seconds(60));
//   cursor.state().status(7);                     // after the tick that it stands behind
//   cursor.events();                              // of that tick
//   while (true) {                                // from there on
//     switch (cursor.Next()) {
//       case RecordItem::kTick: ... cursor.events() ...
//       case RecordItem::kNone: return;
//     }
//   }
//
// A seek reads from the nearest state before the place, at most some hundred kilobytes. Cursors of
// one record do not disturb each other; RecordReader::Refresh must not run at the same time.
#ifndef COPPICE_BT_CORE_RECORD_RECORD_CURSOR_H_
#define COPPICE_BT_CORE_RECORD_RECORD_CURSOR_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/frames/follower.h"
#include "bt_core/frames/history_decoder.h"
#include "bt_core/record/record_reader.h"

namespace coppice {

enum class RecordItem : std::uint8_t {
  kNone,    ///< the end of what there is; Next may find more after RecordReader::Refresh
  kTick,    ///< events(): a tick, a halt, or what happened between two ticks
  kState,   ///< state(): at the start, behind a gap or damage, after a jump
  kTree,    ///< tree(), state(): the tree is another one from here on
  kGap,     ///< gap()
  kNote,    ///< note()
  kEnd,     ///< end(): the record was closed
  kDamage,  ///< damages().back(): something could not be read; a state follows
};

class RecordCursor {
 public:
  /// Stands behind the first state; if that is damaged, all nodes are idle, and damages() says so.
  /// The record must live longer.
  explicit RecordCursor(const RecordReader& record);
  ~RecordCursor();

  /// Goes behind the tick of that number, or the last one before it if it is not in the record; not
  /// before the first state. What bears the number without being the tick comes behind it.
  void SeekTick(std::uint64_t tick);
  /// Goes behind the last tick that began at that time or before it.
  void SeekTime(Time time);
  /// Goes back to the first state.
  void SeekBegin();
  /// Goes behind everything.
  void SeekLast();

  /// Goes on by one item, whose functions below are then valid until the next call.
  RecordItem Next();

  const RecordReader& record() const { return record_; }
  const TreeDescription& tree() const;
  /// How the tree stands here.
  const HistoryFollower& state() const { return *state_; }
  /// What the last kTick brought; after a seek, that of the tick that the cursor stands behind.
  /// Without words and with number 0 if there was none since the state. A tick that stood at a
  /// breakpoint comes in parts: each brings all of it so far, and the last one is_whole.
  const TickEvents& events() const { return events_; }

  const HistoryGap& gap() const;
  const HistoryNote& note() const;
  const HistoryEnd& end() const;

  /// What could not be read on the way. A seek forgets what was before.
  const std::vector<RecordDamage>& damages() const { return damages_; }

 private:
  class Items;

  static TreeSize SizeOf(const TreeDescription& tree);
  template <class IsBefore>
  const RecordKeyframe& LastKeyframe(IsBefore is_before) const;
  void GoTo(const RecordKeyframe& keyframe);
  template <class IsBehind, class IsThere>
  void Seek(IsBehind is_behind, IsThere is_there);
  void OpenFile(std::uint32_t number);
  bool Load();
  void Read(const FrameFile::Span& span);
  void ReadTree(const FrameFile::Span& span);
  void ShowState();
  void AddDamage(std::uint64_t offset, std::uint64_t bytes);
  RecordItem Take();
  void TakeTick();

  const RecordReader& record_;
  std::unique_ptr<FrameFile> file_;
  std::uint32_t file_number_ = 0;
  std::uint64_t offset_ = 0;  // of the next frame
  HistoryDecoder decoder_;
  std::unique_ptr<Items> items_;  // of the frames before it
  std::uint32_t tree_ = 0;
  std::uint32_t next_tree_ = 0;  // from the next state on
  bool shows_state_ = true;      // the next state is news, whatever its cause
  std::optional<HistoryFollower> state_;
  TickEvents events_{};
  std::vector<std::uint32_t> words_;  // of a tick that came in parts
  std::vector<RecordDamage> damages_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_RECORD_CURSOR_H_
