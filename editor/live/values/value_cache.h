// What the tiles show of large values, worked out once for a value and not once a frame.
//
//   cache.Look(run);                                         // once a frame
//   const SlotView& view = cache.Of(slot, values[slot]);
//   if (view.rows) ...
#ifndef COPPICE_EDITOR_LIVE_VALUES_VALUE_CACHE_H_
#define COPPICE_EDITOR_LIVE_VALUES_VALUE_CACHE_H_

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "editor/live/values/value_rows.h"
#include "editor/live/values/value_table.h"

namespace coppice::editor {

/// For people, as PrintValueBytes; of a long text so many bytes, and how many there are in all.
std::string PrintBeginning(std::string_view bytes, std::size_t most_bytes);

/// The text or JSON in the bytes, not copied; empty for others.
std::string_view TextOfBytes(std::string_view bytes);

class RunView;

/// Of one slot.
class SlotView {
 public:
  /// Takes over other bytes; what is as it was is not worked out again.
  void Show(const std::string& bytes);

  /// Null: the value cannot be opened.
  const ValueRows* rows();
  /// The numbers of the rows in sight: with words those that have them, if there are any.
  const std::vector<std::uint32_t>& Shown(const std::string& words);
  /// Whether all words are in the path of the key or in the value (live/key_search.h).
  bool IsFound(const std::string& path, const std::string& words);
  /// Null: the value is no table.
  const ValueTable* table();
  /// Opens or folds that row.
  void Turn(std::uint32_t row);
  bool IsRowOpen(std::uint32_t row);
  /// How often rows were read.
  int readings() const { return readings_; }

 private:
  std::string bytes_;
  bool is_read_ = false;
  std::optional<ValueRows> rows_;
  bool is_table_read_ = false;
  std::optional<ValueTable> table_;
  ValueFolds folds_;
  bool is_listed_ = false;
  std::string listed_words_;
  bool shows_found_ = false;
  std::vector<std::uint32_t> shown_;
  bool is_searched_ = false;
  std::string searched_words_;
  bool is_found_ = false;
  int readings_ = 0;
};

class ValueCache {
 public:
  /// What decides about values: another moment of a run, or another run. With the same moment as
  /// the last time, no value is looked at again.
  void Look(const std::string& moment);

  SlotView& Of(const std::string& path, const std::string& bytes);
  /// How often rows were read, of all values.
  int readings() const;

 private:
  struct Entry {
    SlotView view;
    std::string moment;
    const char* data = nullptr;
    std::size_t size = 0;
  };
  std::string moment_;
  std::map<std::string, Entry> entries_;
};

/// The cache, at the moment of the run that is shown; made if there is none yet.
ValueCache& CacheFor(std::shared_ptr<ValueCache>& cache, const RunView& run);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_VALUES_VALUE_CACHE_H_
