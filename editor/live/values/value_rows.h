// A JSON value as rows that open and close: a flat array in the order of the text, made once for a
// value; what is shown are numbers of rows. Nothing is copied out of the text.
//
//   const std::optional<ValueRows> rows = ReadValueRows(text);       // the text must stay
//   for (const std::uint32_t row : ShownRows(*rows, folds)) ...      // draw those in sight
#ifndef COPPICE_EDITOR_LIVE_VALUES_VALUE_ROWS_H_
#define COPPICE_EDITOR_LIVE_VALUES_VALUE_ROWS_H_

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::editor {

struct ValueRow {
  std::uint32_t key = 0;  ///< of a member: where its name begins, behind the quote
  std::uint32_t key_length = 0;
  std::uint32_t begin = 0;  ///< of the value in the text
  std::uint32_t length = 0;
  std::uint32_t parent = 0;  ///< of the first row: itself
  std::uint32_t end = 0;     ///< behind the last row in it: its next sibling, if it has one
  std::uint32_t number = 0;  ///< among its siblings
  std::uint32_t count = 0;   ///< entries in it
  std::uint16_t depth = 0;
  char kind = 0;  ///< '{', '[', or 0 for what cannot be opened
};

struct ValueRows {
  static constexpr std::size_t kMostBytes = std::size_t{1} << 28U;  ///< of a text
  static constexpr std::size_t kMostRows = std::size_t{1} << 22U;
  static constexpr std::uint16_t kMostDepth = 200;
  static constexpr std::uint32_t kFew = 8;  ///< entries that are open from the beginning

  std::string_view text;
  std::vector<ValueRow> rows;

  std::string_view TextOf(const ValueRow& row) const { return text.substr(row.begin, row.length); }
  std::string_view KeyOf(const ValueRow& row) const { return text.substr(row.key, row.key_length); }
  /// "/poses/3/x"; of the first row "".
  std::string PathOf(std::uint32_t row) const;
};

/// Nothing if the text is no list and no object, or is none that ends as it began.
std::optional<ValueRows> ReadValueRows(std::string_view text);

/// Paths of what the user has opened or folded, against what it is from the beginning.
using ValueFolds = std::set<std::string>;
bool IsOpen(const ValueRows& rows, std::uint32_t row, const ValueFolds& folds);

/// What is in sight, without the first row, which stands for the whole.
std::vector<std::uint32_t> ShownRows(const ValueRows& rows, const ValueFolds& folds);

/// Those with one of these words in their name or in their own value, capital or not, with what
/// they are in; all are open.
std::vector<std::uint32_t> FoundRows(const ValueRows& rows, const std::string& words);

/// "[1 200]" or "{3}": kind and size.
std::string SizeText(const ValueRow& row);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_VALUES_VALUE_ROWS_H_
