#include "robot_app/knowledge/import/csv_table.h"

#include <csv.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include "bt_core/model/utf8.h"

namespace coppice::robot::knowledge {
namespace {

constexpr std::size_t kLongestRow = 1 << 20;  // bytes
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool IsUtf8(const std::string& text) { return FindInvalidUtf8(text) == text.size(); }

class Reader {
 public:
  Reader(const std::string& file, const CsvFormat& format, Diagnostics& diagnostics,
         const std::function<void(CsvRow&)>& use)
      : format_(format), diagnostics_(diagnostics), use_(use) {
    row_.where.file = file;
    csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI);
  }
  ~Reader() { csv_free(&parser_); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  void Read(const ByteSource& bytes) {
    std::array<char, 1 << 16> buffer;
    while (const std::size_t size = bytes(buffer.data(), buffer.size())) {
      if (!Feed({buffer.data(), size})) return;
    }
    if (csv_fini(&parser_, OnField, OnRow, this) != 0) Fail("expected a closing quote");
    if (!has_header_ && !has_failed_) Fail("expected a row that names the columns");
  }

 private:
  // In pieces that end with a line, so that it is known in which one a field ends.
  bool Feed(std::string_view text) {
    while (!text.empty() && !has_failed_) {
      const std::size_t end = text.find('\n');
      const std::size_t size = end == std::string_view::npos ? text.size() : end + 1;
      row_bytes_ += size;
      if (csv_parse(&parser_, text.data(), size, OnField, OnRow, this) != size) {
        Fail("expected a comma behind a closing quote");
      } else if (row_bytes_ > kLongestRow) {
        Fail("expected a closing quote");
      }
      if (end != std::string_view::npos) ++line_;
      text.remove_prefix(size);
    }
    return !has_failed_;
  }

  void Fail(const std::string& problem) {
    has_failed_ = true;
    diagnostics_.Error({row_.where.file, line_, 0}, problem);
  }

  static void OnField(void* field, std::size_t size, void* self) {
    static_cast<Reader*>(self)->AddField({static_cast<const char*>(field), size});
  }
  static void OnRow(int, void* self) { static_cast<Reader*>(self)->EndRow(); }

  void AddField(std::string_view field) {
    if (cells_.empty()) {
      const auto breaks = std::count(field.begin(), field.end(), '\n');
      row_.where.line = line_ - static_cast<std::uint32_t>(breaks);
    }
    cells_.emplace_back(field);
  }

  void EndRow() {
    row_bytes_ = 0;
    if (!has_failed_) has_header_ ? UseRow() : UseHeader();
    cells_.clear();
  }

  void UseHeader() {
    has_header_ = true;
    width_ = cells_.size();
    if (!cells_.empty() && cells_[0].compare(0, 3, kByteOrderMark) == 0) cells_[0].erase(0, 3);
    std::vector<std::string> known;
    for (const CsvColumn& column : format_.columns) known.push_back(column.name);
    for (const CsvColumn& column : format_.columns) {
      const auto found = std::find(cells_.begin(), cells_.end(), column.name);
      place_.push_back(found == cells_.end()
                           ? std::nullopt
                           : std::optional(static_cast<std::size_t>(found - cells_.begin())));
      if (!place_.back() && column.is_needed) Fail("expected a column \"" + column.name + "\"");
    }
    if (format_.has_others) return;
    for (const std::string& cell : cells_) {
      if (std::find(known.begin(), known.end(), cell) != known.end()) continue;
      diagnostics_.Error(row_.where, "unknown column \"" + cell + "\"", DidYouMean(cell, known));
    }
  }

  void UseRow() {
    if (cells_.size() != width_) {
      diagnostics_.Error(row_.where, "expected " + std::to_string(width_) + " fields, not " +
                                         std::to_string(cells_.size()));
      return;
    }
    row_.fields.clear();
    for (const auto place : place_) row_.fields.push_back(place ? cells_[*place] : std::string());
    if (!std::all_of(row_.fields.begin(), row_.fields.end(), IsUtf8)) {
      diagnostics_.Error(row_.where, "expected UTF-8; save the file in that encoding");
      return;
    }
    use_(row_);
  }

  const CsvFormat& format_;
  Diagnostics& diagnostics_;
  const std::function<void(CsvRow&)>& use_;
  csv_parser parser_{};
  CsvRow row_;
  std::vector<std::string> cells_;                 // of the row that is being read
  std::vector<std::optional<std::size_t>> place_;  // of each column of the format in the table
  std::size_t width_ = 0;
  std::size_t row_bytes_ = 0;
  std::uint32_t line_ = 1;
  bool has_header_ = false, has_failed_ = false;
};

}  // namespace

ByteSource BytesOf(std::string_view text) {
  return [text](char* buffer, std::size_t size) mutable {
    const std::size_t count = std::min(size, text.size());
    std::memcpy(buffer, text.data(), count);
    text.remove_prefix(count);
    return count;
  };
}

void ReadCsv(const std::string& file, const ByteSource& bytes, const CsvFormat& format,
             Diagnostics& diagnostics, const std::function<void(CsvRow&)>& use) {
  Reader(file, format, diagnostics, use).Read(bytes);
}

}  // namespace coppice::robot::knowledge
