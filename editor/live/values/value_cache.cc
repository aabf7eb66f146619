#include "editor/live/values/value_cache.h"

#include "bt_core/data/value_bytes.h"
#include "editor/live/key_search.h"
#include "editor/live/run_view.h"

namespace coppice::editor {

std::string_view TextOfBytes(std::string_view bytes) {
  const ValueForm form = FormOfValue(bytes);
  return form == ValueForm::kJson || form == ValueForm::kText ? bytes.substr(1)
                                                              : std::string_view();
}

std::string PrintBeginning(std::string_view bytes, std::size_t most_bytes) {
  const std::string_view text = TextOfBytes(bytes);
  return text.size() > most_bytes ? BeginningOf(text, most_bytes) : PrintValueBytes(bytes);
}

void SlotView::Show(const std::string& bytes) {
  if (bytes == bytes_) return;
  bytes_ = bytes;
  rows_.reset();
  table_.reset();
  is_table_read_ = is_read_ = is_listed_ = is_searched_ = false;
}

const ValueRows* SlotView::rows() {
  if (!is_read_) {
    is_read_ = true;
    ++readings_;
    rows_ = ReadValueRows(TextOfBytes(bytes_));
  }
  return rows_ ? &*rows_ : nullptr;
}

const ValueTable* SlotView::table() {
  if (!is_table_read_) {
    is_table_read_ = true;
    table_ = ReadTable(bytes_);
  }
  return table_ ? &*table_ : nullptr;
}

const std::vector<std::uint32_t>& SlotView::Shown(const std::string& words) {
  if (is_listed_ && listed_words_ == words) return shown_;
  is_listed_ = true;
  listed_words_ = words;
  shown_.clear();
  if (!rows()) return shown_;
  if (!words.empty()) shown_ = FoundRows(*rows_, words);
  shows_found_ = !shown_.empty();
  if (!shows_found_) shown_ = ShownRows(*rows_, folds_);
  return shown_;
}

bool SlotView::IsFound(const std::string& path, const std::string& words) {
  if (is_searched_ && searched_words_ == words) return is_found_;
  is_searched_ = true;
  searched_words_ = words;
  const std::string_view text = TextOfBytes(bytes_);
  const std::string printed = text.empty() ? PrintValueBytes(bytes_) : std::string();
  return is_found_ = IsKeyFound(path, text.empty() ? std::string_view(printed) : text, words);
}

void SlotView::Turn(std::uint32_t row) {
  if (!rows() || row >= rows_->rows.size() || shows_found_) return;
  const std::string path = rows_->PathOf(row);
  if (folds_.erase(path) == 0) folds_.insert(path);
  is_listed_ = false;
}

bool SlotView::IsRowOpen(std::uint32_t row) {
  if (!rows() || rows_->rows[row].count == 0) return false;
  return shows_found_ || IsOpen(*rows_, row, folds_);
}

void ValueCache::Look(const std::string& moment) { moment_ = moment; }

SlotView& ValueCache::Of(const std::string& path, const std::string& bytes) {
  Entry& entry = entries_[path];
  const bool is_same =
      entry.moment == moment_ && entry.data == bytes.data() && entry.size == bytes.size();
  if (!is_same) {
    entry.view.Show(bytes);
    entry.moment = moment_;
    entry.data = bytes.data();
    entry.size = bytes.size();
  }
  return entry.view;
}

int ValueCache::readings() const {
  int sum = 0;
  for (const auto& [path, entry] : entries_) sum += entry.view.readings();
  return sum;
}

ValueCache& CacheFor(std::shared_ptr<ValueCache>& cache, const RunView& run) {
  if (!cache) cache = std::make_shared<ValueCache>();
  const Playhead& playhead = run.playhead();
  cache->Look(run.bookmark_name() + "\n" + std::to_string(run.run().size()) + "\n" +
              std::to_string(playhead.tick()) + (playhead.is_at_now() ? "+" : ""));
  return *cache;
}

}  // namespace coppice::editor
