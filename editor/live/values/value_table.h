// A value of a blackboard as a table: a list of JSON objects, or an object whose only list this is.
// Columns are the members of all objects, in the order in which they come.
#ifndef COPPICE_EDITOR_LIVE_VALUES_VALUE_TABLE_H_
#define COPPICE_EDITOR_LIVE_VALUES_VALUE_TABLE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coppice::editor {

struct ValueTable {
  static constexpr std::size_t kMostRows = 2000;  ///< what is beyond is left out
  static constexpr std::size_t kMostColumns = 32;

  struct Cell {
    std::string text;
    std::optional<double> number;  ///< by which it is sorted
  };

  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;  ///< as many cells as columns; without text: no such member

  /// In another order; the same rows stay as they are.
  void Sort(std::size_t column, bool descending);
};

/// Whether the bytes (data/value_bytes.h) may be a table: quick, for lists of all values.
bool LooksLikeTable(const std::string& bytes);

/// Nothing if they are none.
std::optional<ValueTable> ReadTable(const std::string& bytes);

/// What words such as READY, BACKING_OFF or GIVEN_UP say; kNone: nothing that is known.
enum class CellLevel : std::uint8_t { kNone, kOff, kGood, kBusy, kWarning, kBad };
CellLevel LevelOf(const std::string& word);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_VALUES_VALUE_TABLE_H_
